#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <utility>

#include "prosup/prepare/body_outline.h"

namespace prosup::tests {
namespace {

/// A slab of fat below 1.75 mm of skin, whose front is y = 20 mm, or more to the sides; voxels of
/// 1 mm, blurred with 0.8 mm.
image::ScalarImage slab(double skin, double fat) {
  image::VoxelGrid grid;
  grid.size = {30, 50, 30};
  image::ScalarImage scan(grid);
  std::mt19937 generator(1);
  std::normal_distribution<double> noise(0., 3.);
  const auto step = [](double depth) { return 0.5 + 0.5 * std::erf(depth / 0.8 / std::sqrt(2.)); };
  for (std::size_t k = 0; k < 30; ++k)
    for (std::size_t j = 0; j < 50; ++j)
      for (std::size_t i = 0; i < 30; ++i) {
        const double depth = double(j) - 20. - 0.1 * double(i);
        scan(i, j, k) = float(
            std::abs(skin * step(depth) + (fat - skin) * step(depth - 1.75) + noise(generator)));
      }
  return scan;
}

// In voxels of 1 mm, the middle of the edge of skin on bright and on suppressed fat.
TEST(Outline, LiesAtTheEdgeOfTheSkin) {
  for (const auto& [skin, fat] : {std::pair(85., 190.), std::pair(120., 45.)}) {
    const prepare::Outline outline = prepare::find_outline(slab(skin, fat), false);
    double error = 0.;
    for (std::size_t k = 5; k < 25; ++k)
      for (std::size_t i = 5; i < 25; ++i) {
        std::size_t j = 0;
        while (outline.body(i, j, k) == 0)
          ++j;
        error += double(j) - 0.5 - 20. - 0.1 * double(i);
      }
    EXPECT_NEAR(error / 400., 0., 0.5) << skin; // mm, half a voxel
  }
}

} // namespace
} // namespace prosup::tests
