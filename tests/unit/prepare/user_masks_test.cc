#include <gtest/gtest.h>

#include <cmath>

#include "expect_error.h"
#include "preparation_of.h"
#include "synthetic_chest.h"

namespace prosup::tests {
namespace {

const std::vector<Override> told{"Preparation/Contrast=t1", "Preparation/Bias correction=none"};

const SyntheticChest& chest() {
  static const SyntheticChest scan;
  return scan;
}

/// 1 where a point of a grid is `chosen`.
template <typename Chosen>
image::LabelImage mask_of(const image::VoxelGrid& grid, const Chosen& chosen) {
  image::LabelImage mask(grid);
  for (std::size_t k = 0; k < grid.size[2]; ++k)
    for (std::size_t j = 0; j < grid.size[1]; ++j)
      for (std::size_t i = 0; i < grid.size[0]; ++i)
        mask(i, j, k) = chosen(grid.physical(double(i), double(j), double(k)));
  return mask;
}

double radius(const image::Point<3>& p) {
  return std::hypot(p[0], p[1] - SyntheticChest::axis_y);
}

/// A muscle that is 8 mm thick and 8 mm further in front than the wall that the image shows.
bool is_drawn_muscle(const image::Point<3>& p) {
  return radius(p) > 100. && radius(p) < 108.;
}

bool is_drawn_gland(const image::Point<3>& p) {
  return std::abs(p[0] + 60.) < 10. && std::abs(p[1] - 5.) < 10. && std::abs(p[2]) < 8.;
}

// Each voxel in front of the drawn muscle is breast, each behind its front is chest.
TEST(UserMasks, ChestAndGlandReplaceWhatWouldBeFound) {
  const image::VoxelGrid& grid = chest().image.grid;
  prepare::UserMasks masks;
  masks.chest = mask_of(grid, is_drawn_muscle);
  masks.gland = mask_of(grid, is_drawn_gland);
  const prepare::PreparedScan scan = PreparationOf(told).run(chest().image, masks);
  const auto behind = mask_of(grid, [](const auto& p) { return radius(p) < 108.; });
  for (std::size_t v = 0; v < scan.labels.values.size(); ++v) {
    const unsigned label = scan.labels.values[v];
    if (label != 0) {
      ASSERT_EQ(label == 1, behind.values[v] != 0) << v;
    }
    ASSERT_EQ(label == 3, masks.gland->values[v] != 0) << v;
    ASSERT_EQ(scan.gland.values[v], masks.gland->values[v] != 0 ? 1.f : 0.f) << v;
  }
  EXPECT_TRUE(scan.confidence.doubts.empty());
}

// A mask of the left breast without its skin, on voxels of its own.
TEST(UserMasks, ABreastLimitsItsTissue) {
  image::VoxelGrid grid;
  grid.size = {80, 110, 70};
  grid.origin = image::Point<3>(20., -70., -35.);
  const auto is_within = [](const image::Point<3>& p, double size) {
    return std::pow((p[0] - 60.) / 34., 2) + std::pow((p[1] - 30.) / 76., 2) +
                   std::pow(p[2] / 23., 2) <
               size &&
           p[1] < 28. * size;
  };
  prepare::UserMasks masks;
  masks.breast = mask_of(grid, [&](const auto& p) { return is_within(p, 1.); });
  const prepare::PreparedScan scan = PreparationOf(told).run(chest().image, masks);
  const auto& size = scan.labels.grid.size;
  std::size_t n_rind = 0;
  for (std::size_t k = 0; k < size[2]; ++k)
    for (std::size_t j = 0; j < size[1]; ++j)
      for (std::size_t i = 0; i < size[0]; ++i) {
        const image::Point<3> p = scan.labels.grid.physical(double(i), double(j), double(k));
        const unsigned label = scan.labels(i, j, k);
        if (p[0] < 10.) { // the other breast
          ASSERT_LE(label, 1u);
        } else if (is_within(p, 0.9)) { // a voxel off its border
          ASSERT_GE(label, 2u);
        } else if (label >= 2)
          ++n_rind;
      }
  EXPECT_GT(n_rind, 100u); // skin stays tissue
}

TEST(UserMasks, ThatMarkNothingOfTheScanAreRefused) {
  prepare::UserMasks masks;
  masks.gland = image::LabelImage(chest().image.grid);
  expect_error([&] { PreparationOf(told).run(chest().image, masks); },
               {"mask of the gland", "marks no voxel"});
}

} // namespace
} // namespace prosup::tests
