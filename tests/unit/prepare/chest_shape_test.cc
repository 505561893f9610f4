#include "prepare/chest_shape.h"

#include <gtest/gtest.h>

#include <cmath>

namespace prosup::tests {
namespace {

using prepare::ColumnMap;

constexpr std::size_t n_rows = 20, n_columns = 41;

std::vector<char> all_columns() {
  return std::vector<char>(n_rows * n_columns, 1);
}

/// A cone of a height on the columns about a place.
void add_cone(ColumnMap& map, std::size_t row, std::size_t column, double height, double slope) {
  for (std::size_t r = 0; r < n_rows; ++r)
    for (std::size_t c = 0; c < n_columns; ++c)
      map(r, c) += std::max(
          0., height - slope * std::hypot(double(r) - double(row), double(c) - double(column)));
}

// A chest that is a cylinder about another axis, with a steep hill on a tenth of it.
TEST(ChestShape, SmoothChestsPassBelowHills) {
  prepare::TrunkGrid grid;
  grid.n_rows = n_rows;
  grid.n_columns = n_columns;
  grid.first_angle = -1.;
  grid.angle_step = 0.05;
  ColumnMap radius(n_rows, n_columns), truth(n_rows, n_columns);
  for (std::size_t r = 0; r < n_rows; ++r)
    for (std::size_t c = 0; c < n_columns; ++c)
      truth(r, c) = 100. + 10. * std::cos(2. * grid.angle(c)) + 0.5 * double(r);
  radius = truth;
  add_cone(radius, 9, 24, 150., 30.);
  const ColumnMap smooth = prepare::smooth_chest(grid, radius, all_columns());
  for (std::size_t column = 0; column < smooth.values.size(); ++column)
    EXPECT_NEAR(smooth.values[column], truth.values[column], 1.); // mm
}

TEST(ChestShape, HillsAreClosedAllAround) {
  ColumnMap map(n_rows, n_columns);
  for (std::size_t r = 0; r < n_rows; ++r)
    for (std::size_t c = 0; c < n_columns; ++c)
      map(r, c) = 0.5 * double(c); // a slope is no hill
  add_cone(map, 10, 12, 20., 5.);
  add_cone(map, 0, 30, 20., 5.); // this one reaches the border
  const ColumnMap height = prepare::hill_height(map, all_columns());
  EXPECT_GT(height(10, 12), 17.);
  EXPECT_LT(height(10, 12), 20.1);
  EXPECT_EQ(height(0, 30), 0.);
  EXPECT_EQ(height(10, 30), 0.);
  const std::vector<char> found = prepare::hills(height, 3., 9.);
  EXPECT_EQ(found[10 * n_columns + 12], 1);
  EXPECT_EQ(found[10 * n_columns + 14], 1);
  EXPECT_EQ(found[10 * n_columns + 20], 0);
  EXPECT_EQ(found[30], 0);
  EXPECT_EQ(prepare::hills(height, 3., 25.), std::vector<char>(n_rows * n_columns, 0));
}

// What does not count is a border.
TEST(ChestShape, ColumnsThatDoNotCountAreABorder) {
  ColumnMap map(n_rows, n_columns);
  add_cone(map, 10, 12, 20., 5.);
  std::vector<char> counts = all_columns();
  counts[10 * n_columns + 13] = 0;
  EXPECT_LT(prepare::hill_height(map, counts)(10, 12), 0.1);
}

TEST(ChestShape, BridgesContinueAPlane) {
  ColumnMap map(n_rows, n_columns);
  std::vector<char> unknown(n_rows * n_columns, 0);
  for (std::size_t r = 0; r < n_rows; ++r)
    for (std::size_t c = 0; c < n_columns; ++c) {
      const bool hole = r > 4 && r < 12 && c > 10 && c < 20;
      map(r, c) = hole ? 500. : double(r) + 2. * double(c);
      unknown[r * n_columns + c] = hole;
    }
  prepare::bridge(map, unknown);
  EXPECT_NEAR(map(8, 15), 38., 0.1);
}

} // namespace
} // namespace prosup::tests
