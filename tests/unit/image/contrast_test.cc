#include <gtest/gtest.h>

#include "expect_error.h"
#include "prosup/image/contrast.h"
#include "test_grids.h"

namespace prosup::tests {
namespace {

using namespace prosup::image;

constexpr TissueIntensities mr{-0.3, 0.9, 0.2}, ct{-0.5, 0.3, 0.8};

/// Layers of four voxels each along x: air, fat, gland.
LabelImage layers() {
  LabelImage labels(cube_grid(12));
  for (std::size_t v = 0; v < labels.values.size(); ++v)
    labels.values[v] = std::uint8_t(std::array<int, 3>{0, 2, 3}[v % 12 / 4]);
  return labels;
}

ScalarImage painted(const LabelImage& labels, const TissueIntensities& of) {
  ScalarImage image(labels.grid);
  for (std::size_t v = 0; v < labels.values.size(); ++v)
    image.values[v] = float(labels.values[v] == 0   ? of.air
                            : labels.values[v] == 2 ? of.fat
                                                    : of.gland);
  return image;
}

TEST(MedianIntensity, IsThatOfTheLabel) {
  ScalarImage image(cube_grid(2));
  LabelImage labels(image.grid);
  image.values = {5.f, -1.f, 7.f, 100.f, 6.f, 50.f, 50.f, 50.f};
  labels.values = {2, 2, 2, 2, 2, 0, 3, 3};
  EXPECT_EQ(median_intensity(image, labels, 2), 6.f);
  EXPECT_EQ(median_intensity(image, labels, 3), 50.f);
  expect_error([&] { median_intensity(image, labels, 4); }, {"label 4"});
  expect_error([&] { median_intensity(image, LabelImage(cube_grid(3)), 2); }, {"size"});
}

TEST(ConvertContrast, GivesTissueItsIntensityInTheOtherModality) {
  const LabelImage labels = layers();
  const ScalarImage converted = convert_contrast(painted(labels, mr), labels, mr, ct);
  const ScalarImage expected = painted(labels, ct);
  for (std::size_t v = 0; v < labels.values.size(); ++v)
    ASSERT_NEAR(converted.values[v], expected.values[v], 1e-6) << v % 12;
}

TEST(ConvertContrast, IsLinearWithinTheTissue) {
  const LabelImage labels = layers();
  ScalarImage image = painted(labels, mr);
  image(10, 5, 5) = float(0.5 * (mr.fat + mr.gland));
  const ScalarImage converted = convert_contrast(image, labels, mr, ct);
  EXPECT_NEAR(converted(10, 5, 5), 0.5 * (ct.fat + ct.gland), 1e-6);
}

// A voxel of fat that is a third air is no gland, which the line of the tissues
// would make of it.
TEST(ConvertContrast, TheOutlineFades) {
  const LabelImage labels = layers();
  ScalarImage image = painted(labels, mr);
  const auto faded = [](const TissueIntensities& of) { return (of.air + 2. * of.fat) / 3.; };
  image(4, 5, 5) = image(3, 5, 5) = float(faded(mr));
  const ScalarImage converted = convert_contrast(image, labels, mr, ct);
  EXPECT_NEAR(converted(3, 5, 5), faded(ct), 1e-6);
  EXPECT_LT(converted(4, 5, 5), ct.fat + 0.1);
  EXPECT_GT(converted(4, 5, 5), faded(ct));
}

TEST(ConvertContrast, SaysWhatIsWrong) {
  const LabelImage labels = layers();
  const ScalarImage image = painted(labels, mr);
  expect_error([&] { convert_contrast(image, labels, {0., 0.5, 0.5}, ct); }, {"fat must differ"});
  expect_error([&] { convert_contrast(image, labels, {0.5, 0.5, 0.}, ct); }, {"fat must differ"});
}

} // namespace
} // namespace prosup::tests
