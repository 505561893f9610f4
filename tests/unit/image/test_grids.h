#ifndef PROSUP_TESTS_UNIT_IMAGE_TEST_GRIDS_H
#define PROSUP_TESTS_UNIT_IMAGE_TEST_GRIDS_H

#include <cmath>
#include <random>

#include "prosup/image/voxel_image.h"

namespace prosup::tests {

using dealii::Point;
using dealii::Tensor;
using image::LabelImage;
using image::ScalarImage;
using image::VoxelGrid;

/// Anisotropic grid with the direction cosines of a RAS NIfTI file.
inline VoxelGrid flipped_grid() {
  VoxelGrid grid;
  grid.size = {9, 8, 7};
  grid.origin = Point<3>(30., 12., -41.);
  grid.spacing = Tensor<1, 3>({1.5, 1.25, 2.5});
  grid.direction[0][0] = -1.;
  grid.direction[1][1] = -1.;
  return grid;
}

/// The same, turned by 30 degrees about z and 20 degrees about x.
inline VoxelGrid oblique_grid() {
  VoxelGrid grid = flipped_grid();
  const double a = M_PI / 6., b = M_PI / 9.;
  const Tensor<2, 3> about_z(
      {{std::cos(a), -std::sin(a), 0.}, {std::sin(a), std::cos(a), 0.}, {0., 0., 1.}});
  const Tensor<2, 3> about_x(
      {{1., 0., 0.}, {0., std::cos(b), -std::sin(b)}, {0., std::sin(b), std::cos(b)}});
  grid.direction = about_x * about_z * grid.direction;
  return grid;
}

inline VoxelGrid cube_grid(std::size_t n, double spacing = 1.) {
  VoxelGrid grid;
  grid.size = {n, n, n};
  grid.spacing = Tensor<1, 3>({spacing, spacing, spacing});
  return grid;
}

inline ScalarImage random_image(const VoxelGrid& grid) {
  ScalarImage image(grid);
  std::mt19937 generator(7);
  std::uniform_real_distribution<float> random(-100.f, 100.f);
  for (float& value : image.values)
    value = random(generator);
  return image;
}

/// Calls function(voxel, X) for each voxel and its centre.
template <typename Function>
void for_each_voxel(const VoxelGrid& grid, const Function& function) {
  std::size_t voxel = 0;
  for (std::size_t k = 0; k < grid.size[2]; ++k)
    for (std::size_t j = 0; j < grid.size[1]; ++j)
      for (std::size_t i = 0; i < grid.size[0]; ++i)
        function(voxel++, grid.physical(double(i), double(j), double(k)));
}

/// Mask of a ball.
inline LabelImage ball(const VoxelGrid& grid, const Point<3>& centre, double radius) {
  LabelImage mask(grid);
  for_each_voxel(grid, [&](std::size_t voxel, const Point<3>& X) {
    mask.values[voxel] = X.distance(centre) < radius ? 1 : 0;
  });
  return mask;
}

} // namespace prosup::tests

#endif
