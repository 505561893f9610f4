#include <gtest/gtest.h>

#include "expect_error.h"
#include "prosup/image/filters.h"
#include "test_grids.h"

namespace prosup::tests {
namespace {

using namespace prosup::image;

TEST(SignedDistance, OfASphere) {
  VoxelGrid grid = oblique_grid();
  grid.size = {48, 56, 32};
  grid.spacing = Tensor<1, 3>({1., 1., 1.5});
  const Point<3> centre = grid.physical(23.3, 27.8, 15.6);
  const double radius = 18.;
  const ScalarImage distance = signed_distance(ball(grid, centre, radius));
  double sum_near = 0.;
  unsigned n_near = 0;
  for_each_voxel(grid, [&](std::size_t voxel, const Point<3>& X) {
    const double exact = X.distance(centre) - radius;
    const double error = distance.values[voxel] - exact;
    // The faces of a voxelised sphere are up to half a voxel diagonal off it.
    EXPECT_LT(std::abs(error), 0.5 * std::sqrt(1. + 1. + 2.25));
    if (std::abs(exact) < 1.5) {
      sum_near += error;
      ++n_near;
    }
  });
  EXPECT_NEAR(sum_near / n_near, 0., 0.05) << "mean near the boundary, mm";
}

TEST(SignedDistance, IsZeroOnFacesAndIgnoresTheImageBorder) {
  VoxelGrid grid = cube_grid(8);
  grid.spacing = Tensor<1, 3>({2., 1., 1.});
  LabelImage mask(grid);
  for (std::size_t v = 0; v < mask.values.size(); ++v)
    mask.values[v] = v % 8 < 3 ? 1 : 0; // x index 0, 1, 2
  const ScalarImage distance = signed_distance(mask);
  for (std::size_t k = 0; k < 8; ++k)
    for (std::size_t j = 0; j < 8; ++j)
      for (std::size_t i = 0; i < 8; ++i)
        EXPECT_NEAR(distance(i, j, k), 2. * double(i) - 5., 1e-5);
}

TEST(SignedDistance, NeedsAnInsideAndAnOutside) {
  expect_error([] { signed_distance(LabelImage(cube_grid(4))); }, {"mask"});
  expect_error([] { signed_distance(LabelImage(cube_grid(4), 1)); }, {"mask"});
}

TEST(ExtendFromNearest, TakesTheNearestKnownVoxel) {
  VoxelGrid grid = oblique_grid(); // anisotropic
  grid.size = {14, 11, 9};
  VectorImage field(grid);
  LabelImage known(grid);
  std::mt19937 generator(5);
  std::vector<std::size_t> seeds;
  for (unsigned n = 0; n < 12; ++n) {
    const std::size_t seed = generator() % grid.n_voxels();
    known.values[seed] = 3;
    seeds.push_back(seed);
  }
  std::vector<Point<3>> centres;
  for_each_voxel(grid, [&](std::size_t, const Point<3>& X) { centres.push_back(X); });
  for (std::size_t v = 0; v < grid.n_voxels(); ++v)
    field.values[v] = {float(v), known.values[v] ? 1.f : -1.f, 0.f};
  extend_from_nearest(field, known);
  for (std::size_t v = 0; v < grid.n_voxels(); ++v) {
    ASSERT_EQ(field.values[v][1], 1.f);
    const auto source = static_cast<std::size_t>(field.values[v][0]);
    double nearest = 1e300;
    for (const std::size_t seed : seeds)
      nearest = std::min(nearest, centres[v].distance(centres[seed]));
    EXPECT_NEAR(centres[v].distance(centres[source]), nearest, 1e-5);
  }
}

TEST(ExtendFromNearest, NeedsSomethingKnownOnItsOwnGrid) {
  VectorImage field(cube_grid(4));
  expect_error([&] { extend_from_nearest(field, LabelImage(cube_grid(4))); }, {"empty"});
  expect_error([&] { extend_from_nearest(field, LabelImage(cube_grid(5), 1)); }, {"size"});
}

} // namespace
} // namespace prosup::tests
