#include <gtest/gtest.h>

#include <numeric>

#include "prosup/image/filters.h"
#include "test_grids.h"

namespace prosup::tests {
namespace {

using namespace prosup::image;

std::size_t n_inside(const LabelImage& mask) {
  return std::size_t(std::count(mask.values.begin(), mask.values.end(), 1));
}

/// Sets a box of voxels, first to last inclusive.
void set_box(LabelImage& mask, std::array<std::size_t, 3> first, std::array<std::size_t, 3> last,
             std::uint8_t value) {
  for (std::size_t k = first[2]; k <= last[2]; ++k)
    for (std::size_t j = first[1]; j <= last[1]; ++j)
      for (std::size_t i = first[0]; i <= last[0]; ++i)
        mask(i, j, k) = value;
}

TEST(SelectLabels, GivesOneWhereALabelIsListed) {
  LabelImage labels(cube_grid(2));
  labels.values = {0, 1, 2, 3, 2, 255, 0, 1};
  EXPECT_EQ(select_labels(labels, {2, 255}).values,
            (std::vector<std::uint8_t>{0, 0, 1, 0, 1, 1, 0, 0}));
  EXPECT_EQ(n_inside(select_labels(labels, {0, 1000})), 2u);
  EXPECT_EQ(n_inside(select_labels(labels, {})), 0u);
}

TEST(LargestComponent, KeepsTheLargestFaceConnectedPart) {
  LabelImage mask(cube_grid(10));
  set_box(mask, {1, 1, 1}, {3, 3, 3}, 9); // 27 voxels
  set_box(mask, {4, 4, 4}, {7, 7, 5}, 4); // 32 voxels, touch the others at a corner only
  set_box(mask, {9, 9, 9}, {9, 9, 9}, 9);
  const LabelImage largest = largest_component(mask);
  EXPECT_EQ(n_inside(largest), 32u);
  EXPECT_EQ(largest(5, 5, 5), 1);
  EXPECT_EQ(largest(2, 2, 2), 0);
}

TEST(LargestComponent, LeavesAnEmptyMaskEmpty) {
  EXPECT_EQ(n_inside(largest_component(LabelImage(cube_grid(3)))), 0u);
}

TEST(SmallParts, AreThoseBelowAVolume) {
  LabelImage mask(cube_grid(10));
  mask.grid.spacing[0] = mask.grid.spacing[1] = mask.grid.spacing[2] = 2.; // mm; voxels of 8 mm^3
  set_box(mask, {1, 1, 1}, {3, 3, 3}, 9);                                  // 27 voxels, 216 mm^3
  set_box(mask, {4, 4, 4}, {7, 7, 5}, 4); // 32, 256 mm^3, touch the others at a corner only
  EXPECT_EQ(n_inside(without_small_parts(mask, 216.)), 59u);
  const LabelImage large = without_small_parts(mask, 217.);
  EXPECT_EQ(n_inside(large), 32u);
  EXPECT_EQ(large(5, 5, 5), 1);
  EXPECT_EQ(n_inside(without_small_parts(mask, 300.)), 0u);
  EXPECT_EQ(n_inside(without_small_parts(LabelImage(cube_grid(3)), 1.)), 0u);
}

TEST(InnerPart, LeavesOutWhatIsNearTheOutlineButNotWhatIsNearTheBorder) {
  LabelImage mask(cube_grid(10));
  mask.grid.spacing[0] = 0.7;
  mask.grid.spacing[1] = 1.;
  mask.grid.spacing[2] = 3.;
  set_box(mask, {1, 0, 2}, {9, 9, 7}, 1);
  set_box(mask, {6, 5, 4}, {6, 5, 4}, 0); // a hole
  const LabelImage inner = inner_part(mask, 2.);
  EXPECT_EQ(inner(3, 0, 4), 0); // 3 voxels of 0.7 mm from the outline
  EXPECT_EQ(inner(4, 0, 4), 1);
  EXPECT_EQ(inner(9, 9, 4), 1);
  EXPECT_EQ(inner(4, 0, 2), 0); // one voxel of 3 mm from it
  EXPECT_EQ(inner(4, 0, 3), 1);
  EXPECT_EQ(inner(9, 5, 4), 0); // 3, 2 and one from the hole
  EXPECT_EQ(inner(6, 7, 4), 0);
  EXPECT_EQ(inner(6, 8, 4), 1);
  EXPECT_EQ(inner(6, 5, 5), 0);
  EXPECT_EQ(inner(6, 5, 6), 1);
  EXPECT_EQ(n_inside(inner_part(mask, 100.)), 0u);
}

TEST(FillHoles, FillsCavitiesButNoHollowThatReachesTheBorder) {
  LabelImage mask(cube_grid(12));
  set_box(mask, {1, 1, 0}, {10, 10, 9}, 1);
  const std::size_t full = n_inside(mask);
  set_box(mask, {3, 3, 3}, {4, 4, 4}, 0);  // a cavity
  set_box(mask, {5, 5, 5}, {5, 5, 5}, 0);  // another, joined to it by a corner only
  set_box(mask, {7, 7, 6}, {8, 8, 11}, 0); // a well open to the top
  set_box(mask, {8, 2, 0}, {8, 2, 2}, 0);  // a well open to the image border
  const LabelImage filled = fill_holes(mask);
  EXPECT_EQ(n_inside(filled), full - 4 * 4 - 3);
  EXPECT_EQ(filled(3, 4, 3), 1);
  EXPECT_EQ(filled(5, 5, 5), 1);
  EXPECT_EQ(filled(7, 8, 6), 0);
  EXPECT_EQ(filled(8, 2, 1), 0);
  EXPECT_EQ(filled(0, 0, 0), 0);
}

TEST(FillHoles, KeepsFullAndEmptyMasks) {
  EXPECT_EQ(n_inside(fill_holes(LabelImage(cube_grid(3), 5))), 27u);
  EXPECT_EQ(n_inside(fill_holes(LabelImage(cube_grid(3)))), 0u);
}

} // namespace
} // namespace prosup::tests
