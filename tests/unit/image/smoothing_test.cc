#include <gtest/gtest.h>

#include <numeric>

#include "expect_error.h"
#include "prosup/image/filters.h"
#include "test_grids.h"

namespace prosup::tests {
namespace {

using namespace prosup::image;

TEST(GaussianSmooth, TurnsAPointIntoAGaussianInMillimetres) {
  VoxelGrid grid = cube_grid(41);
  grid.spacing = Tensor<1, 3>({1., 0.5, 2.});
  ScalarImage image(grid);
  image(20, 20, 20) = 1.f;
  const double sigma = 2.5;
  const ScalarImage smoothed = gaussian_smooth(image, sigma);
  const double peak = grid.voxel_volume() / std::pow(2. * M_PI * sigma * sigma, 1.5);
  const Point<3> centre = grid.physical(20., 20., 20.);
  for_each_voxel(grid, [&](std::size_t voxel, const Point<3>& X) {
    // The y extent of 20 mm cuts the tail at four sigma.
    const double expected = peak * std::exp(-(X - centre).norm_square() / (2. * sigma * sigma));
    EXPECT_NEAR(smoothed.values[voxel], expected, 0.01 * peak);
  });
}

TEST(GaussianSmooth, HasTheSecondMomentOfItsWidthWhereVoxelsAreCoarse) {
  const ScalarImage image = [] {
    ScalarImage point(cube_grid(21, 3.));
    point(10, 10, 10) = 1.f;
    return point;
  }();
  for (const double sigma : {1., 1.8, 2.5, 4.}) {
    const ScalarImage smoothed = gaussian_smooth(image, sigma);
    double sum = 0., second_moment = 0.;
    for_each_voxel(image.grid, [&](std::size_t voxel, const Point<3>& X) {
      sum += smoothed.values[voxel];
      second_moment += smoothed.values[voxel] * (X[0] - 30.) * (X[0] - 30.);
      EXPECT_GT(smoothed.values[voxel], -2e-3) << "ringing at sigma " << sigma;
    });
    EXPECT_NEAR(sum, 1., 1e-3) << sigma;
    // The recursive filter's approximation is about 3% narrow.
    EXPECT_NEAR(std::sqrt(second_moment / sum) / sigma, 1., 0.05) << sigma;
  }
}

TEST(GaussianSmooth, KeepsConstantsUpToTheBorderAndTakesThinImages) {
  VoxelGrid grid = cube_grid(12);
  grid.size = {12, 3, 1};
  for (const float value : gaussian_smooth(ScalarImage(grid, 5.f), 2.).values)
    EXPECT_NEAR(value, 5.f, 1e-4);
}

TEST(GaussianSmooth, CopiesAtZeroAndRefusesNegativeWidth) {
  const ScalarImage image = random_image(oblique_grid());
  EXPECT_EQ(gaussian_smooth(image, 0.).values, image.values);
  expect_error([&] { gaussian_smooth(image, -1.); }, {"-1 mm"});
}

} // namespace
} // namespace prosup::tests
