#include <gtest/gtest.h>

#include "expect_error.h"
#include "prosup/image/filters.h"
#include "test_grids.h"

namespace prosup::tests {
namespace {

using namespace prosup::image;

/// Outer corners of the first and last voxel.
std::array<Point<3>, 2> field_of_view(const VoxelGrid& grid) {
  return {grid.physical(-0.5, -0.5, -0.5),
          grid.physical(double(grid.size[0]) - 0.5, double(grid.size[1]) - 0.5,
                        double(grid.size[2]) - 0.5)};
}

VoxelGrid large_oblique_grid() {
  VoxelGrid grid = oblique_grid();
  grid.size = {48, 48, 32};
  return grid;
}

class ResampleIsotropic : public ::testing::TestWithParam<double> {};

TEST_P(ResampleIsotropic, KeepsTheFieldOfView) {
  const ScalarImage resampled = resample_isotropic(ScalarImage(oblique_grid()), GetParam());
  const auto before = field_of_view(oblique_grid()), after = field_of_view(resampled.grid);
  EXPECT_LT(before[0].distance(after[0]), 1e-10);
  EXPECT_LT(before[1].distance(after[1]), 1e-10);
  for (unsigned d = 0; d < 3; ++d)
    EXPECT_NEAR(resampled.grid.spacing[d] / GetParam(), 1., 0.5 / double(resampled.grid.size[d]));
}

TEST_P(ResampleIsotropic, KeepsALinearRamp) {
  ScalarImage image(large_oblique_grid());
  const Tensor<1, 3> slope({0.5, -2., 1.25});
  for_each_voxel(image.grid, [&](std::size_t voxel, const Point<3>& X) {
    image.values[voxel] = float(slope * X);
  });
  const ScalarImage resampled = resample_isotropic(image, GetParam());
  // Near the border the image goes on as a constant, which bends the ramp.
  const double border = 5. * std::max(GetParam(), 1.);
  unsigned n_checked = 0;
  for_each_voxel(resampled.grid, [&](std::size_t voxel, const Point<3>& X) {
    const Point<3> index = image.grid.continuous_index(X);
    for (unsigned d = 0; d < 3; ++d)
      if (index[d] * image.grid.spacing[d] < border ||
          (double(image.grid.size[d]) - 1. - index[d]) * image.grid.spacing[d] < border)
        return;
    ++n_checked;
    EXPECT_NEAR(resampled.values[voxel], slope * X, 5e-3) << "values up to 200";
  });
  EXPECT_GT(n_checked, 100u);
}

INSTANTIATE_TEST_SUITE_P(Spacings, ResampleIsotropic, ::testing::Values(0.8, 1.3, 2.5, 3.7));

TEST(ResampleIsotropic, RemovesWhatTheCoarserGridCannotShow) {
  // A checkerboard averages out; without smoothing it would alias.
  ScalarImage image(cube_grid(32));
  for_each_voxel(image.grid, [&](std::size_t voxel, const Point<3>& X) {
    image.values[voxel] = long(X[0] + X[1] + X[2]) % 2 == 0 ? 1.f : -1.f;
  });
  for (const float value : resample_isotropic(image, 4.).values)
    EXPECT_LT(std::abs(value), 0.02f);
}

TEST(ResampleIsotropic, CopiesAnImageThatHasTheSpacing) {
  const ScalarImage image = random_image(cube_grid(8, 2.));
  EXPECT_EQ(resample_isotropic(image, 2.).values, image.values);
}

TEST(ResampleIsotropic, RefusesSpacingThatIsNotPositive) {
  expect_error([] { resample_isotropic(ScalarImage(cube_grid(4)), 0.); }, {"spacing", "0 mm"});
}

double volume(const LabelImage& labels, std::uint8_t label) {
  return double(std::count(labels.values.begin(), labels.values.end(), label)) *
         labels.grid.voxel_volume();
}

TEST(ResampleLabels, KeepsVolumes) {
  VoxelGrid grid = oblique_grid();
  grid.size = {44, 50, 28};
  const Point<3> centre = grid.physical(22., 25., 14.);
  LabelImage labels = ball(grid, centre, 26.);
  for_each_voxel(grid, [&](std::size_t voxel, const Point<3>& X) {
    if (X.distance(centre) < 15.)
      labels.values[voxel] = 200;
  });
  for (const double spacing : {1., 2., 4.}) {
    const LabelImage resampled = resample_isotropic(labels, spacing);
    EXPECT_NEAR(volume(resampled, 1) / volume(labels, 1), 1., 0.03) << spacing;
    EXPECT_NEAR(volume(resampled, 200) / volume(labels, 200), 1., 0.03) << spacing;
    EXPECT_NEAR(volume(resampled, 0) + volume(resampled, 1) + volume(resampled, 200),
                volume(labels, 0) + volume(labels, 1) + volume(labels, 200), 1e-6);
  }
}

TEST(ResampleLabels, IsSmootherThanTakingTheNearest) {
  // A ball in slices 4 mm apart, brought to 1 mm: how many voxels are
  // on the wrong side of the sphere, against copying each slice fourfold.
  VoxelGrid grid = cube_grid(48);
  grid.size[2] = 12;
  grid.spacing[2] = 4.;
  const Point<3> centre(24., 24., 22.);
  const LabelImage resampled = resample_isotropic(ball(grid, centre, 18.), 1.);
  const auto error = [&](const auto& is_inside) {
    double wrong = 0.;
    for_each_voxel(resampled.grid, [&](std::size_t voxel, const Point<3>& X) {
      if (is_inside(voxel, X) != (X.distance(centre) < 18.))
        ++wrong;
    });
    return wrong;
  };
  const double by_shape =
      error([&](std::size_t voxel, const Point<3>&) { return resampled.values[voxel] == 1; });
  const double by_slices = error([&](std::size_t, const Point<3>& X) {
    return Point<3>(X[0], X[1], 4. * std::round(X[2] / 4.)).distance(centre) < 18.;
  });
  EXPECT_LT(by_shape, 0.7 * by_slices);
}

TEST(Warp, PullsFromTheDisplacedPosition) {
  ScalarImage loaded(large_oblique_grid());
  const Tensor<1, 3> slope({0.5, -2., 1.25});
  for_each_voxel(loaded.grid, [&](std::size_t voxel, const Point<3>& x) {
    loaded.values[voxel] = float(slope * x);
  });
  VoxelGrid grid = cube_grid(5, 2.);
  grid.origin = loaded.grid.physical(24., 24., 16.);
  const Tensor<1, 3> u({1.5, -0.75, 2.25});
  VectorImage displacement(grid, {1.5f, -0.75f, 2.25f});
  displacement.values[0] = {1000.f, 0.f, 0.f};
  const ScalarImage warped = warp(loaded, displacement, -7.f);
  EXPECT_TRUE(warped.grid.coincides_with(grid));
  for_each_voxel(grid, [&](std::size_t voxel, const Point<3>& X) {
    EXPECT_NEAR(warped.values[voxel], voxel == 0 ? -7. : slope * (X + u), 1e-3);
  });
}

} // namespace
} // namespace prosup::tests
