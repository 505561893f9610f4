#ifndef PROSUP_MESH_MASK_MESHER_H
#define PROSUP_MESH_MASK_MESHER_H

#include <deal.II/base/parameter_acceptor.h>

#include "prosup/core/labels.h"
#include "prosup/mesh/mesh_source.h"

namespace prosup::mesh {

/// Meshes the largest connected part of the tissue labels, with its holes filled; section
/// "Meshing". The surface is a smoothed level set of the distance to the mask (VTK),
/// remeshed to triangles of the edge length, and filled with tetrahedra by gmsh. Where the
/// mask touches the border of the image, the mesh ends exactly in the outer faces of the
/// voxels.
class MaskMesher : public MeshSource, public dealii::ParameterAcceptor {
public:
  /// Keeps a reference to `labels`.
  explicit MaskMesher(const Labels& labels);
  explicit MaskMesher(Labels&&) = delete;
  void declare_parameters(dealii::ParameterHandler& prm) override;

  /// If gmsh fails, as it may where the mask is thinner than an edge, tries again with edges
  /// of 0.8 and 0.64 times the length.
  /// @throws Error if no voxel has a tissue label, if the breast is too small for the edge
  /// length, or if gmsh still fails.
  TetMesh mesh(const image::LabelImage& labels) const override;

  double edge_length = 6.5; ///< mm
  double smoothing = 1.;    ///< standard deviation, in voxel edges (cube root of the volume)

private:
  const Labels& labels_;
};

} // namespace prosup::mesh

#endif
