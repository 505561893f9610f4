#include "prosup/unloading/chest_surface.h"

#include <gtest/gtest.h>

#include <cmath>

#include "prosup/core/error.h"

namespace prosup::tests {
namespace {

using namespace dealii;

constexpr double radius = 120.; // of a cylinder along z through the origin, mm

/// Voxels of 1 mm of a cylinder, on a grid turned about z and tilted.
image::LabelImage cylinder() {
  image::VoxelGrid grid;
  grid.size = {80, 60, 50};
  const double turn = 0.3, tilt = 0.2;
  const Tensor<2, 3> about_z(
      {{std::cos(turn), -std::sin(turn), 0.}, {std::sin(turn), std::cos(turn), 0.}, {0., 0., 1.}});
  const Tensor<2, 3> about_x(
      {{1., 0., 0.}, {0., std::cos(tilt), -std::sin(tilt)}, {0., std::sin(tilt), std::cos(tilt)}});
  grid.direction = about_z * about_x;
  grid.origin = Point<3>(-20., -150., -25.);
  image::LabelImage labels(grid);
  for (std::size_t k = 0; k < 50; ++k)
    for (std::size_t j = 0; j < 60; ++j)
      for (std::size_t i = 0; i < 80; ++i) {
        const Point<3> x = grid.physical(double(i), double(j), double(k));
        labels(i, j, k) = std::hypot(x[0], x[1]) < radius ? 1 : 2;
      }
  return labels;
}

// Nodes slide along level sets: what matters is that a level set keeps its distance
// to the cylinder, and that the normals are smooth.
TEST(ChestSurface, IsSmootherThanItsVoxels) {
  const image::LabelImage labels = cylinder();
  const Point<3> low(-15., -125., -10.), high(40., -105., 15.);
  const unloading::ChestSurface surface(labels, 1, 1.5, low, high, 20.);
  double least = 1e9, most = -1e9, steepest = 0.;
  for (double angle = -0.1; angle < 0.3; angle += 0.003)
    for (double z = -8.; z < 12.; z += 0.7) {
      const Tensor<1, 3> outward({std::sin(angle), -std::cos(angle), 0.});
      const Tensor<1, 3> x = radius * outward + Tensor<1, 3>({0., 0., z});
      Tensor<1, 3> normal;
      const double distance = surface.distance(x, normal);
      least = std::min(least, distance);
      most = std::max(most, distance);
      steepest = std::max(steepest, (normal - outward).norm());
      EXPECT_NEAR(normal.norm(), 1., 1e-9);
    }
  EXPECT_LT(most - least, 0.25); // half a voxel would be 0.5
  EXPECT_LT(std::abs(most + least), 0.4);
  EXPECT_LT(steepest, 0.06); // radians
}

TEST(ChestSurface, GoesOnStraightBeyondTheImage) {
  const image::LabelImage labels = cylinder();
  const unloading::ChestSurface surface(labels, 1, 1.5, {-15., -125., -10.}, {40., -105., 15.},
                                        20.);
  Tensor<1, 3> normal;
  const double near = surface.distance(Tensor<1, 3>({0., -radius, 40.}), normal);
  EXPECT_NEAR(near, 0., 1.5);
  EXPECT_LT(normal[1], -0.95);
  EXPECT_TRUE(std::isfinite(surface.distance(Tensor<1, 3>({1e6, -1e6, 1e6}), normal)));
}

TEST(ChestSurface, RefusesAnImageWithoutChest) {
  EXPECT_THROW(
      unloading::ChestSurface(cylinder(), 7, 1.5, {-15., -125., -10.}, {40., -105., 15.}, 20.),
      Error);
}

} // namespace
} // namespace prosup::tests
