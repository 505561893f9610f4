#ifndef PROSUP_TESTS_UNIT_MESH_TEST_LABELS_H
#define PROSUP_TESTS_UNIT_MESH_TEST_LABELS_H

#include <cmath>
#include <functional>

#include "prosup/image/voxel_image.h"
#include "prosup/mesh/tet_mesh.h"

namespace prosup::tests {

using dealii::Point;
using mesh::BoundaryFace;
using mesh::BoundaryPart;
using mesh::TetMesh;

/// A grid of `size` voxels, its centre at the physical origin.
inline image::VoxelGrid centred_grid(const std::array<std::size_t, 3>& size,
                                     const dealii::Tensor<1, 3>& spacing,
                                     const dealii::Tensor<2, 3>& direction) {
  image::VoxelGrid grid;
  grid.size = size;
  grid.spacing = spacing;
  grid.direction = direction;
  dealii::Tensor<1, 3> half;
  for (unsigned d = 0; d < 3; ++d)
    half[d] = 0.5 * spacing[d] * (double(size[d]) - 1.);
  grid.origin = Point<3>() - direction * half;
  return grid;
}

inline image::VoxelGrid centred_cube(std::size_t n, double spacing = 1.) {
  return centred_grid({n, n, n}, dealii::Tensor<1, 3>({spacing, spacing, spacing}),
                      image::VoxelGrid().direction);
}

/// Labels given as a function of the physical position.
inline image::LabelImage make_labels(const image::VoxelGrid& grid,
                                     const std::function<unsigned(const Point<3>&)>& label_at) {
  image::LabelImage labels(grid);
  for (std::size_t k = 0; k < grid.size[2]; ++k)
    for (std::size_t j = 0; j < grid.size[1]; ++j)
      for (std::size_t i = 0; i < grid.size[0]; ++i)
        labels(i, j, k) = std::uint8_t(label_at(grid.physical(double(i), double(j), double(k))));
  return labels;
}

inline image::LabelImage ball_labels(const image::VoxelGrid& grid, double radius) {
  return make_labels(grid, [&](const Point<3>& x) { return x.norm() < radius ? 2u : 0u; });
}

inline double ball_volume(double radius) {
  return 4. / 3. * M_PI * std::pow(radius, 3);
}

inline double face_area(const TetMesh& mesh, const BoundaryFace& face) {
  const auto& x = mesh.points;
  return 0.5 *
         cross_product_3d(x[face.nodes[1]] - x[face.nodes[0]], x[face.nodes[2]] - x[face.nodes[0]])
             .norm();
}

inline double area_of(const TetMesh& mesh, BoundaryPart part) {
  double area = 0.;
  for (const BoundaryFace& face : mesh.boundary_faces)
    if (face.part == part)
      area += face_area(mesh, face);
  return area;
}

} // namespace prosup::tests

#endif
