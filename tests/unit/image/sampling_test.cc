#include "prosup/image/sampling.h"

#include <gtest/gtest.h>

#include <limits>

#include "test_grids.h"

namespace prosup::tests {
namespace {

using namespace prosup::image;

TEST(Sampler, HasTheVoxelValuesAtVoxelCentres) {
  const ScalarImage image = random_image(oblique_grid());
  const Sampler sampler(image);
  for_each_voxel(image.grid, [&](std::size_t voxel, const Point<3>& X) {
    EXPECT_NEAR(sampler.value(X), image.values[voxel], 1e-3);
  });
}

TEST(Sampler, IsExactForTrilinearFunctions) {
  ScalarImage image(oblique_grid());
  const Tensor<1, 3> slope({0.5, -2., 1.25});
  for_each_voxel(image.grid, [&](std::size_t voxel, const Point<3>& X) {
    image.values[voxel] = float(slope * X + 3.);
  });
  const Sampler sampler(image);
  const Point<3> X = image.grid.physical(3.3, 5.9, 0.2);
  Tensor<1, 3> gradient;
  EXPECT_NEAR(sampler.value(X), slope * X + 3., 1e-4);
  EXPECT_NEAR(sampler.value_and_gradient(X, gradient), slope * X + 3., 1e-4);
  EXPECT_LT((gradient - slope).norm(), 1e-4);
}

TEST(Sampler, GradientIsTheDerivativeOfTheInterpolant) {
  const ScalarImage image = random_image(oblique_grid());
  const Sampler sampler(image);
  // The interpolant is linear along each grid axis but not in space: the
  // central difference of step h is off by h^2 times its third derivative,
  // which is that of the trilinear term, and by the rounding of float values.
  const double h = 0.02;
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> in_cell(0.1, 0.9);
  for (unsigned n = 0; n < 200; ++n) {
    const Point<3> X = image.grid.physical(n % 8 + in_cell(generator), n % 7 + in_cell(generator),
                                           n % 6 + in_cell(generator));
    Tensor<1, 3> gradient;
    EXPECT_FLOAT_EQ(sampler.value_and_gradient(X, gradient), sampler.value(X));
    for (unsigned d = 0; d < 3; ++d) {
      Point<3> ahead = X, behind = X;
      ahead[d] += h;
      behind[d] -= h;
      const double difference =
          (double(sampler.value(ahead)) - double(sampler.value(behind))) / (2. * h);
      EXPECT_NEAR(gradient[d], difference, 0.05) << "of values up to 100 per mm";
    }
  }
}

TEST(Sampler, IsConstantBeyondTheBorderAxisByAxis) {
  const ScalarImage image = random_image(oblique_grid());
  const VoxelGrid& grid = image.grid;
  const Sampler sampler(image);
  const Point<3> beyond = grid.physical(-4., 2.4, 3.7);
  EXPECT_NEAR(sampler.value(beyond), sampler.value(grid.physical(0., 2.4, 3.7)), 1e-3);
  Tensor<1, 3> gradient;
  sampler.value_and_gradient(beyond, gradient);
  const Tensor<1, 3> along = gradient * grid.direction;
  EXPECT_NEAR(along[0], 0., 1e-5);
  EXPECT_GT(std::abs(along[1]), 1e-2);
  EXPECT_GT(std::abs(along[2]), 1e-2);
  EXPECT_EQ(sampler.value(grid.physical(1e6, 1e6, 1e6)), image(8, 7, 6));
  EXPECT_EQ(sampler.value(grid.physical(-1e6, 1e6, -1e6)), image(0, 7, 0));
}

TEST(Sampler, TakesImagesOfOneVoxel) {
  VoxelGrid grid = cube_grid(1);
  grid.size[1] = 2;
  ScalarImage image(grid);
  image.values = {1.f, 3.f};
  const Sampler sampler(image);
  Tensor<1, 3> gradient;
  EXPECT_FLOAT_EQ(sampler.value_and_gradient(Point<3>(0., 0.25, 0.), gradient), 1.5f);
  EXPECT_LT((gradient - Tensor<1, 3>({0., 2., 0.})).norm(), 1e-6);
}

TEST(Sampler, StaysInsideMemoryForPositionsThatAreNotNumbers) {
  const ScalarImage image(oblique_grid(), 4.f);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(Sampler(image).value(Point<3>(nan, nan, nan)), 4.f);
  EXPECT_FALSE(Sampler(image).inside(Point<3>(nan, nan, nan)));
}

TEST(Sampler, FieldOfViewEndsAtVoxelFaces) {
  const ScalarImage image(oblique_grid());
  const VoxelGrid& grid = image.grid;
  const Sampler sampler(image);
  EXPECT_TRUE(sampler.inside(grid.physical(-0.49, 0., 6.49)));
  EXPECT_FALSE(sampler.inside(grid.physical(-0.51, 0., 0.)));
  EXPECT_FALSE(sampler.inside(grid.physical(0., 0., 6.51)));
}

TEST(NearestLabel, IsTheVoxelsLabelInsideAndZeroOutside) {
  LabelImage labels(oblique_grid(), 2);
  const VoxelGrid& grid = labels.grid;
  labels(8, 0, 3) = 7;
  EXPECT_EQ(nearest_label(labels, grid.physical(8.49, -0.49, 2.51)), 7);
  EXPECT_EQ(nearest_label(labels, grid.physical(7.49, -0.49, 2.51)), 2);
  EXPECT_EQ(nearest_label(labels, grid.physical(8.51, 0., 3.)), 0);
  EXPECT_EQ(nearest_label(labels, grid.physical(8., -0.51, 3.)), 0);
  EXPECT_EQ(nearest_label(labels, grid.physical(1e300, 0., 0.)), 0);
}

} // namespace
} // namespace prosup::tests
