#ifndef PROSUP_MESH_MESH_SOURCE_H
#define PROSUP_MESH_MESH_SOURCE_H

#include "prosup/image/voxel_image.h"
#include "prosup/mesh/tet_mesh.h"

namespace prosup::mesh {

/// Makes the mesh of a breast from its label image: MaskMesher, or one of a host program.
///
/// The result must have
/// - `points` in the coordinates of the labels, LPS mm, each a node of some cell;
/// - `cells` with positive tet_volume();
/// - in `tissue` for each cell one of the labels in Labels::tissues;
/// - in `boundary_faces` each face that belongs to a single cell, once, with the nodes
///   ordered so that its normal points outwards, and its part: the cut plane where the body
///   ends at the border of the image, the chest wall where it touches the label
///   Labels::chest, and the skin elsewhere.
///
/// The same labels must give the same mesh. mesh::make_distributed() refuses cells and faces
/// that are not valid.
class MeshSource {
public:
  virtual ~MeshSource() = default;

  /// Called on a single rank, the only one that has the labels: it must not communicate.
  /// @throws Error if there is no breast in the labels, or it cannot be meshed.
  virtual TetMesh mesh(const image::LabelImage& labels) const = 0;
};

} // namespace prosup::mesh

#endif
