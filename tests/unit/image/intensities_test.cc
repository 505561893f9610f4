#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "expect_error.h"
#include "prosup/image/filters.h"
#include "test_grids.h"

namespace prosup::tests {
namespace {

using namespace prosup::image;

TEST(RobustRange, IsThePercentilesInsideTheMask) {
  ScalarImage image(cube_grid(10), 1e6f);
  LabelImage mask(image.grid);
  // 0 to 100 in random order inside, a million outside
  std::vector<float> values(101);
  for (std::size_t v = 0; v < values.size(); ++v)
    values[v] = float(v);
  std::shuffle(values.begin(), values.end(), std::mt19937(1));
  for (std::size_t v = 0; v < values.size(); ++v) {
    image.values[9 * v] = values[v];
    mask.values[9 * v] = 2;
  }
  const IntensityRange range = robust_range(image, mask, 1., 97.5);
  EXPECT_NEAR(range.low, 1., 1e-9);
  EXPECT_NEAR(range.high, 97.5, 1e-9);
  const IntensityRange all = robust_range(image, mask, 0., 100.);
  EXPECT_EQ(all.low, 0.);
  EXPECT_EQ(all.high, 100.);
}

TEST(RobustRange, SaysWhatIsWrong) {
  const ScalarImage image = random_image(cube_grid(4));
  const LabelImage mask(image.grid, 1);
  expect_error([&] { robust_range(image, LabelImage(image.grid), 1., 99.); }, {"empty"});
  expect_error([&] { robust_range(image, LabelImage(cube_grid(5), 1), 1., 99.); }, {"size"});
  expect_error([&] { robust_range(image, mask, 99., 1.); }, {"99 and 1"});
  expect_error([&] { robust_range(image, mask, 1., 101.); }, {"1 and 101"});
  expect_error([&] { robust_range(ScalarImage(image.grid, 3.f), mask, 1., 99.); },
               {"same intensity 3"});
}

TEST(Rescale, MapsTheRangeToOneAndClampsOutliers) {
  ScalarImage image(cube_grid(2));
  image.values = {-1000.f, 80.f, 100.f, 150.f, 200.f, 240.f, 260.f, 1e30f};
  const ScalarImage scaled = rescale(image, {100., 200.});
  const float expected[8] = {-0.5f, -0.2f, 0.f, 0.5f, 1.f, 1.4f, 1.5f, 1.5f};
  for (std::size_t v = 0; v < 8; ++v)
    EXPECT_FLOAT_EQ(scaled.values[v], expected[v]);
  expect_error([&] { rescale(image, {2., 2.}); }, {"2 to 2"});
}

} // namespace
} // namespace prosup::tests
