#ifndef PROSUP_TESTS_SMALL_PHANTOM_H
#define PROSUP_TESTS_SMALL_PHANTOM_H

#include "box_of_tets.h"
#include "prosup/phantom/state_images.h"

namespace prosup::tests {

inline phantom::Geometry small_geometry() {
  phantom::Geometry geometry;
  geometry.width = geometry.length = 80.;
  geometry.chest_radius = 70.;
  geometry.height = 40.;
  geometry.sigma = 20.;
  return geometry;
}

/// A brick of tissue in the middle of that phantom, moved as a whole by `shift`.
inline mesh::UnloadedMesh moved_brick(const dealii::Tensor<1, 3>& shift) {
  const mesh::TetMesh brick = box_of_tets({-12., -30., -12.}, {12., -6., 12.}, 3);
  mesh::UnloadedMesh moved{brick, brick.points};
  for (auto& point : moved.mesh.points)
    point += shift;
  return moved;
}

/// Voxels of 1 mm around it.
inline image::VoxelGrid brick_grid() {
  return image::grid_around({-14., -36., -14.}, {14., 4., 14.}, 1., 0.);
}

} // namespace prosup::tests

#endif
