#include <gtest/gtest.h>

#include "prosup/image/filters.h"
#include "test_grids.h"

namespace prosup::tests {
namespace {

using namespace prosup::image;

/// A ball of fat with a core of gland in air, as CT numbers; the air has a little noise.
struct Scan {
  Scan() : image(cube_grid(24)), labels(ball(image.grid, Point<3>(12., 12., 12.), 8.)) {
    const LabelImage core = ball(image.grid, Point<3>(12., 12., 12.), 4.);
    const ScalarImage noise = random_image(image.grid); // from -100 to 100
    for (std::size_t v = 0; v < labels.values.size(); ++v)
      image.values[v] = (labels.values[v] == 0 ? -1000.f
                         : core.values[v] != 0 ? 40.f
                                               : -110.f) +
                        0.1f * noise.values[v];
  }

  /// Sets what is further than `radius` from the centre to `value`.
  void pad(double radius, float value) {
    const LabelImage inside = ball(image.grid, Point<3>(12., 12., 12.), radius);
    for (std::size_t v = 0; v < inside.values.size(); ++v)
      if (inside.values[v] == 0)
        image.values[v] = value;
  }

  ScalarImage image;
  LabelImage labels;
};

TEST(Padding, IsReplacedByAir) {
  for (const float value : {-2000.f, -3024.f, 63536.f})
    for (const double radius : {14., 9.}) { // of the air, little and nearly all is padding
      Scan scan;
      scan.pad(radius, value);
      const auto padding = replace_padding(scan.image, scan.labels);
      ASSERT_TRUE(padding.has_value()) << value;
      EXPECT_EQ(padding->value, value);
      EXPECT_NEAR(padding->air, -1000., 2.);
      EXPECT_NEAR(scan.image(0, 0, 0), -1000., 2.);
      EXPECT_GT(padding->share, 0.1);
      EXPECT_LT(padding->share, 1.);
    }
}

TEST(Padding, IsNotSeenWhereThereIsNone) {
  Scan scan;
  const std::vector<float> before = scan.image.values;
  EXPECT_FALSE(replace_padding(scan.image, scan.labels).has_value());
  // air that is the same everywhere, and a few voxels of the body labelled as air
  for (std::size_t v = 0; v < before.size(); ++v)
    if (scan.labels.values[v] == 0)
      scan.image.values[v] = -1000.f;
  EXPECT_FALSE(replace_padding(scan.image, scan.labels).has_value());
  for (std::size_t v = 0; v < 400; ++v)
    scan.image.values[v] = v % 2 == 0 ? -110.f : 40.f;
  EXPECT_FALSE(replace_padding(scan.image, scan.labels).has_value());
}

} // namespace
} // namespace prosup::tests
