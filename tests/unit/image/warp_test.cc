#include "prosup/image/warp.h"

#include <gtest/gtest.h>

#include <cmath>

#include "expect_error.h"
#include "prosup/image/image_io.h"

namespace prosup::tests {
namespace {

using namespace prosup::image;

VoxelGrid oblique_grid() {
  VoxelGrid grid;
  grid.size = {20, 16, 12};
  grid.spacing = Tensor<1, 3>({1.5, 1., 2.});
  grid.direction = rotation_about(Tensor<1, 3>({0.1, 0.2, -0.1}));
  grid.origin = Point<3>(-10., 5., 3.);
  return grid;
}

template <class Function>
ScalarImage image_of(const VoxelGrid& grid, const Function& function) {
  ScalarImage image(grid);
  std::size_t v = 0;
  for (std::size_t k = 0; k < grid.size[2]; ++k)
    for (std::size_t j = 0; j < grid.size[1]; ++j)
      for (std::size_t i = 0; i < grid.size[0]; ++i)
        image.values[v++] = float(function(grid.physical(double(i), double(j), double(k))));
  return image;
}

const Tensor<1, 3> shift({1.2, -0.7, 0.9});

VectorImage shifted(const VoxelGrid& grid) {
  return VectorImage(grid, {float(shift[0]), float(shift[1]), float(shift[2])});
}

double ramp(const Point<3>& x) {
  return 2. * x[0] - x[1] + 0.5 * x[2];
}
double wave(const Point<3>& x) {
  return std::sin(0.25 * x[0]) * std::cos(0.2 * x[1]);
}

// Linear functions are interpolated exactly, smooth ones by cubic splines nearly.
TEST(Warp, MovesImagesByTheField) {
  const VoxelGrid grid = oblique_grid();
  const VectorImage field = shifted(grid);
  const ScalarImage linear = warp(image_of(grid, ramp), field, Interpolation::linear, -1e3f),
                    spline = warp(image_of(grid, wave), field, Interpolation::bspline, -1e3f);
  std::size_t n = 0;
  for (std::size_t k = 3; k + 3 < grid.size[2]; ++k)
    for (std::size_t j = 3; j + 3 < grid.size[1]; ++j)
      for (std::size_t i = 3; i + 3 < grid.size[0]; ++i, ++n) {
        const Point<3> x = grid.physical(double(i), double(j), double(k)) + shift;
        EXPECT_NEAR(linear(i, j, k), ramp(x), 1e-4);
        EXPECT_NEAR(spline(i, j, k), wave(x), 5e-3);
      }
  EXPECT_GT(n, 500u);
}

TEST(Warp, FillsWhatWasNotImaged) {
  const VoxelGrid grid = oblique_grid();
  const VectorImage far(grid, {500.f, 0.f, 0.f});
  const ScalarImage warped = warp(image_of(grid, ramp), far, Interpolation::linear, -7.f);
  for (const float value : warped.values)
    EXPECT_EQ(value, -7.f);
}

TEST(Warp, ByTheNearestVoxelMakesNoNewValues) {
  const VoxelGrid grid = oblique_grid();
  const ScalarImage labels = image_of(grid, [](const Point<3>& x) { return x[0] > 0. ? 7. : 2.; });
  const ScalarImage warped = warp(labels, shifted(grid), Interpolation::nearest, 0.f);
  std::size_t n_sevens = 0;
  for (const float value : warped.values) {
    EXPECT_TRUE(value == 0.f || value == 2.f || value == 7.f) << value;
    n_sevens += value == 7.f;
  }
  EXPECT_GT(n_sevens, 100u);
}

TEST(FieldSampler, IsLinearInsideAndRigidBeyond) {
  const VoxelGrid grid = oblique_grid();
  VectorImage field(grid);
  const ScalarImage values = image_of(grid, ramp);
  for (std::size_t v = 0; v < values.values.size(); ++v)
    field.values[v] = {values.values[v], -values.values[v], 1.f};
  RigidTransform beyond;
  beyond.translation = Tensor<1, 3>({0., 0., 42.});
  const FieldSampler sampler(field, beyond);
  const Point<3> inside = grid.physical(7.3, 2.9, 10.6);
  EXPECT_NEAR(sampler(inside)[0], ramp(inside), 1e-4);
  EXPECT_NEAR(sampler(inside)[1], -ramp(inside), 1e-4);
  EXPECT_NEAR(sampler(grid.physical(19., 15., 11.))[2], 1., 1e-6); // the last voxel
  EXPECT_EQ(sampler(grid.physical(19.1, 15., 11.)), beyond.translation);
  VoxelGrid fine = grid;
  fine.size = {5, 4, 3};
  fine.spacing *= 0.37;
  const VectorImage other = resampled(field, fine, beyond);
  const Point<3> there = fine.physical(4., 1., 2.);
  EXPECT_NEAR(other(4, 1, 2)[0], ramp(there), 1e-4);
}

TEST(Interpolation, IsChosenByName) {
  for (std::size_t i = 0; i < interpolation_names().size(); ++i)
    EXPECT_EQ(std::size_t(interpolation_of(interpolation_names()[i])), i);
  expect_error([] { interpolation_of("cubic"); }, {"cubic", "linear, nearest, bspline"});
}

TEST(MarksRegions, TellsLabelsFromIntensities) {
  const VoxelGrid grid = oblique_grid();
  EXPECT_TRUE(marks_regions(image_of(grid, [](const Point<3>& x) { return x[0] > 0. ? 9. : 0.; })));
  EXPECT_FALSE(marks_regions(image_of(grid, ramp)));
  EXPECT_FALSE(marks_regions(image_of(grid, [](const Point<3>&) { return 300.; })));
  // Integers, but neighbours have different ones.
  EXPECT_FALSE(marks_regions(image_of(grid, [](const Point<3>& x) {
    return std::floor(100. + 50. * std::sin(7. * x[0] + x[1]));
  })));
}

} // namespace
} // namespace prosup::tests
