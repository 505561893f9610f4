#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "prepare/flood.h"
#include "prepare/map_filters.h"
#include "prosup/prepare/trunk.h"

namespace prosup::tests {
namespace {

using prepare::ColumnMap;

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

TEST(ColumnMaps, QuantilesLeaveOutWhatIsNotKnown) {
  std::vector<double> values{5., unknown, 1., 3., unknown};
  EXPECT_EQ(prepare::quantile_of(values, 0.5), 3.);
  std::vector<double> nothing{unknown};
  EXPECT_TRUE(std::isnan(prepare::quantile_of(nothing, 0.5)));
}

TEST(ColumnMaps, MediansDropASingleOutlierAndSmoothingKeepsAConstant) {
  ColumnMap map(7, 9, 4.);
  map(3, 4) = 100.;
  map(0, 0) = unknown;
  const ColumnMap median = prepare::median_filtered(map, 1, 1);
  for (const double value : median.values)
    EXPECT_EQ(value, 4.);
  for (const double value : prepare::smoothed(median, 1.5).values)
    EXPECT_NEAR(value, 4., 1e-12);
}

TEST(Flood, StopsAtTheDepthAndAtWalls) {
  image::VoxelGrid grid;
  grid.size = {10, 1, 1};
  grid.spacing[0] = 2.;
  image::LabelImage passable(grid, 1), reached(grid, 0);
  passable(8, 0, 0) = 0;
  reached(0, 0, 0) = 1;
  prepare::flood(reached, passable, 6.5);
  for (std::size_t i = 0; i < 10; ++i)
    EXPECT_EQ(reached(i, 0, 0), i <= 3 ? 1 : 0) << i;
  prepare::flood(reached, passable, 1000.);
  EXPECT_EQ(reached(7, 0, 0), 1);
  EXPECT_EQ(reached(9, 0, 0), 0);
}

TEST(Trunk, AnglesRunFromAnteriorToTheLeft) {
  prepare::TrunkAxis axis;
  axis.x = 10.;
  axis.y = 50.;
  EXPECT_NEAR(axis.angle({10., 0., 3.}), 0., 1e-12);
  EXPECT_GT(axis.angle({20., 0., 3.}), 0.); // x grows to the patient's left
  const image::Point<3> p = axis.position(70., 0.4, -5.);
  EXPECT_NEAR(axis.radius(p), 70., 1e-9);
  EXPECT_NEAR(axis.angle(p), 0.4, 1e-12);
  EXPECT_EQ(p[2], -5.);
}

TEST(Trunk, SurfacesAreInterpolatedAndContinued) {
  prepare::TrunkSurface surface;
  surface.grid.n_rows = 2;
  surface.grid.n_columns = 3;
  surface.grid.first_angle = -0.1;
  surface.grid.angle_step = 0.1;
  surface.grid.z_step = 4.;
  surface.radius = {1., 2., 3., 5., 6., 7.};
  EXPECT_NEAR(surface(0., 0.), 2., 1e-12);
  EXPECT_NEAR(surface(0.05, 2.), 4.5, 1e-12);
  EXPECT_NEAR(surface(9., 9.), 7., 1e-12);
}

} // namespace
} // namespace prosup::tests
