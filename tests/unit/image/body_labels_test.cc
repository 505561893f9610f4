#include "prosup/image/body_labels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace prosup::tests {
namespace {

using dealii::Point;
using image::LabelImage;

constexpr std::uint8_t chest = 1, fat = 2;

/// One column along y, front first, on a grid whose second axis points forwards if `is_reversed`.
std::vector<unsigned> filled_column(const std::vector<unsigned>& front_to_back, bool is_reversed) {
  image::VoxelGrid grid;
  grid.size = {2, front_to_back.size(), 1};
  const double sign = is_reversed ? -1. : 1.;
  grid.direction[0][0] = sign;
  grid.direction[1][1] = sign;
  LabelImage labels(grid);
  const auto place = [&](std::size_t n) { return is_reversed ? front_to_back.size() - 1 - n : n; };
  for (std::size_t n = 0; n < front_to_back.size(); ++n)
    labels(1, place(n), 0) = std::uint8_t(front_to_back[n]);
  std::size_t n_filled = 0;
  labels = image::with_inside_of_chest(labels, chest, &n_filled);
  std::vector<unsigned> result;
  std::size_t n_changed = 0;
  for (std::size_t n = 0; n < front_to_back.size(); ++n) {
    result.push_back(labels(1, place(n), 0));
    n_changed += result.back() != front_to_back[n];
    EXPECT_EQ(labels(0, place(n), 0), 0) << "a column without chest";
  }
  EXPECT_EQ(n_filled, n_changed);
  return result;
}

TEST(InsideOfChest, IsWhatLiesBehindASheathUpToTheNextLabel) {
  const std::vector<unsigned> sheath{0, 2, 1, 0, 0, 2, 0, 1, 0}, full{0, 2, 1, 1, 1, 2, 0, 1, 1};
  for (const bool is_reversed : {false, true})
    EXPECT_EQ(filled_column(sheath, is_reversed), full);
}

// Tissue over a hole in the sheath would have a free back.
TEST(InsideOfChest, GoesOnBehindSmallHolesOfASheath) {
  image::VoxelGrid grid;
  grid.size = {60, 20, 60};
  LabelImage labels(grid);
  const auto in_square = [](std::size_t i, std::size_t k, std::size_t low, std::size_t high) {
    return i >= low && i < high && k >= low && k < high;
  };
  for (std::size_t k = 0; k < 60; ++k)
    for (std::size_t i = 0; i < 60; ++i) {
      for (std::size_t j = 2; j < 8; ++j)
        labels(i, j, k) = fat;
      if (!in_square(i, k, 8, 16) && !in_square(i, k, 20, 56) && i > 1)
        for (std::size_t j = 8; j < 11; ++j)
          labels(i, j, k) = chest;
    }
  const LabelImage filled = image::with_inside_of_chest(labels, chest);
  EXPECT_EQ(filled(12, 8, 12), chest) << "in a hole of 8 mm";
  EXPECT_EQ(filled(12, 19, 12), chest);
  EXPECT_EQ(filled(12, 1, 12), 0) << "in front of the skin";
  EXPECT_EQ(filled(38, 12, 38), 0) << "in a hole of 36 mm";
  EXPECT_EQ(filled(0, 12, 40), 0) << "beside the sheath";
}

/// A ball of fat with a chest behind, in voxels of 1 mm; what lies beyond `last` along z is air.
LabelImage ball(double last, double radius = 30.) {
  image::VoxelGrid grid;
  grid.size = {80, 80, 80};
  grid.origin = Point<3>(-39.5, -39.5, -39.5);
  LabelImage labels(grid);
  for (std::size_t k = 0; k < 80; ++k)
    for (std::size_t j = 0; j < 80; ++j)
      for (std::size_t i = 0; i < 80; ++i) {
        const Point<3> x = grid.physical(double(i), double(j), double(k));
        if (std::hypot(x[0], x[1], x[2]) < radius && x[2] < last)
          labels(i, j, k) = x[1] > 15. ? chest : fat;
      }
  return labels;
}

TEST(FlatEnds, AreNoneOnSkin) {
  EXPECT_TRUE(image::flat_ends(ball(100.), chest).empty());
}

TEST(FlatEnds, AreFoundWhereTheMaskIsCutInsideTheImage) {
  const LabelImage labels = ball(10.);
  const auto ends = image::flat_ends(labels, chest);
  ASSERT_EQ(ends.size(), 1u);
  EXPECT_EQ(ends[0].axis, 2u);
  EXPECT_TRUE(ends[0].is_upper);
  EXPECT_EQ(ends[0].border, 50u);
  // A disc of radius 28.3 mm, without the chest.
  EXPECT_NEAR(ends[0].area, 2050., 100.);
  const LabelImage cropped = image::cropped_to(labels, ends);
  EXPECT_EQ(cropped.grid.size, (std::array<std::size_t, 3>{80, 80, 50}));
  EXPECT_EQ(std::count(cropped.values.begin(), cropped.values.end(), fat),
            std::count(labels.values.begin(), labels.values.end(), fat));
}

// The part of the image below a lower end moves the origin, not the body.
TEST(FlatEnds, LeaveTheBodyWhereItIs) {
  LabelImage labels = ball(100.);
  for (std::size_t k = 0; k < 25; ++k)
    for (std::size_t j = 0; j < 80; ++j)
      for (std::size_t i = 0; i < 80; ++i)
        labels(i, j, k) = 0;
  const auto ends = image::flat_ends(labels, chest);
  ASSERT_EQ(ends.size(), 1u);
  EXPECT_FALSE(ends[0].is_upper);
  const LabelImage cropped = image::cropped_to(labels, ends);
  ASSERT_EQ(cropped.grid.size[2], 55u);
  EXPECT_NEAR(cropped.grid.origin[2], -14.5, 1e-12);
  EXPECT_EQ(cropped(40, 40, 0), labels(40, 40, 25));
}

// Tissue that goes on beside the plane shows that it is no border of what was labelled.
TEST(FlatEnds, AreNoneWhereTissueGoesOn) {
  LabelImage labels = ball(10.);
  for (std::size_t k = 50; k < 80; ++k)
    for (std::size_t j = 30; j < 40; ++j)
      for (std::size_t i = 30; i < 50; ++i)
        labels(i, j, k) = fat;
  EXPECT_TRUE(image::flat_ends(labels, chest).empty());
}

/// Labels the voxels from `low` to `high` as fat.
void add_box(LabelImage& labels, const std::array<std::size_t, 3>& low,
             const std::array<std::size_t, 3>& high) {
  for (std::size_t k = low[2]; k < high[2]; ++k)
    for (std::size_t j = low[1]; j < high[1]; ++j)
      for (std::size_t i = low[0]; i < high[0]; ++i)
        labels(i, j, k) = fat;
}

/// A ball, and beside it a box of 12 mm that hangs on a neck of `width`, mm.
LabelImage ball_with_lump(std::size_t width) {
  LabelImage labels = ball(100., 22.);
  add_box(labels, {66, 34, 34}, {78, 46, 46});
  const std::size_t low = 40 - width / 2, high = low + width;
  add_box(labels, {50, low, low}, {66, high, high});
  return labels;
}

TEST(HangingParts, OnAThinNeckAreNoTissue) {
  LabelImage labels = ball_with_lump(4);
  const auto parts = image::take_off_hanging_parts(labels, chest);
  ASSERT_TRUE(parts);
  EXPECT_NEAR(parts->volume, 12. * 12. * 12., 150.);
  EXPECT_NEAR(parts->centre[0], 32., 1.);
  EXPECT_EQ(labels(72, 40, 40), 0);
  // Of the ball nothing is missing.
  LabelImage both = labels;
  add_box(both, {50, 38, 38}, {66, 42, 42});
  LabelImage expected = ball(100., 22.);
  add_box(expected, {50, 38, 38}, {66, 42, 42});
  EXPECT_EQ(both.values, expected.values);
}

TEST(HangingParts, AreNoneWithoutLabels) {
  LabelImage none, air(ball(100.).grid);
  EXPECT_FALSE(image::take_off_hanging_parts(none, chest));
  EXPECT_FALSE(image::take_off_hanging_parts(air, chest));
}

TEST(HangingParts, AreKeptOnAThickNeckOrIfTheyAreLarge) {
  for (LabelImage labels : {ball_with_lump(10), ball(100.)}) {
    if (labels(72, 40, 40) == 0)
      add_box(labels, {75, 10, 10}, {80, 70, 70});
    const LabelImage before = labels;
    EXPECT_FALSE(image::take_off_hanging_parts(labels, chest));
    EXPECT_EQ(labels.values, before.values);
  }
}

} // namespace
} // namespace prosup::tests
