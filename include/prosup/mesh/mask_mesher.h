#ifndef PROSUP_MESH_MASK_MESHER_H
#define PROSUP_MESH_MASK_MESHER_H

#include <deal.II/base/parameter_acceptor.h>

#include "prosup/core/labels.h"
#include "prosup/image/voxel_image.h"
#include "prosup/mesh/tet_mesh.h"

namespace prosup::mesh {

/// Meshes the breast of a label image with tetrahedra: the largest connected
/// part of the tissue labels, holes filled. Its surface is a smoothed level set
/// of the distance to the mask (VTK), remeshed to triangles of the edge length,
/// and filled by gmsh. Where the mask touches the border of the image the mesh
/// ends exactly in the outer faces of the voxels. Needs no MPI; for one rank.
class MaskMesher : public dealii::ParameterAcceptor {
public:
  /// Keeps a reference to `labels`.
  explicit MaskMesher(const Labels& labels);
  explicit MaskMesher(Labels&&) = delete;
  void declare_parameters(dealii::ParameterHandler& prm) override;

  /// The mesh in physical space (LPS, mm). The same labels and parameters give
  /// the same mesh. Where parts of the mask too thin for the edge length make
  /// meshing fail, it is tried again with edges of 0.8 and 0.64 times the length.
  /// @throws Error if a label is missing from the image, if the breast is too
  /// small for the edge length, or if gmsh fails.
  TetMesh run(const image::LabelImage& labels) const;

  double edge_length = 6.5; ///< mm
  double smoothing = 1.;    ///< standard deviation, in cube roots of the volume of a voxel

private:
  const Labels& labels_;
};

} // namespace prosup::mesh

#endif
