#include <gtest/gtest.h>

#include "test_grids.h"

namespace prosup::tests {
namespace {

using namespace prosup::image;

TEST(VoxelGrid, FlippedDirectionRunsBackwardsInXAndY) {
  const VoxelGrid grid = flipped_grid();
  EXPECT_LT(grid.physical(0, 0, 0).distance(grid.origin), 1e-12);
  // origin + direction * spacing * index, by hand
  EXPECT_LT(grid.physical(2, 4, 3).distance(Point<3>(27., 7., -33.5)), 1e-12);
}

TEST(VoxelGrid, ColumnsOfDirectionAreTheAxes) {
  VoxelGrid grid = cube_grid(4, 2.);
  // The first axis points along y, the second along z, the third along x.
  grid.direction = Tensor<2, 3>({{0., 0., 1.}, {1., 0., 0.}, {0., 1., 0.}});
  EXPECT_LT(grid.physical(1, 0, 0).distance(Point<3>(0., 2., 0.)), 1e-12);
  EXPECT_LT(grid.physical(0, 1, 0).distance(Point<3>(0., 0., 2.)), 1e-12);
  EXPECT_LT(grid.physical(0, 0, 1).distance(Point<3>(2., 0., 0.)), 1e-12);
}

TEST(VoxelGrid, ContinuousIndexInvertsPhysical) {
  for (const VoxelGrid& grid : {flipped_grid(), oblique_grid()}) {
    const Point<3> index(1.25, -3.5, 17.);
    EXPECT_LT(grid.continuous_index(grid.physical(1.25, -3.5, 17.)).distance(index), 1e-12);
    const Point<3> x(-11., 53., 8.);
    const Point<3> i = grid.continuous_index(x);
    EXPECT_LT(grid.physical(i[0], i[1], i[2]).distance(x), 1e-11);
  }
}

TEST(VoxelGrid, CoincidesWithinToleranceOnly) {
  const VoxelGrid grid = oblique_grid();
  EXPECT_TRUE(grid.coincides_with(grid));
  VoxelGrid shifted = grid;
  shifted.origin[1] += 5e-4 * 1.25;
  EXPECT_TRUE(grid.coincides_with(shifted));
  shifted.origin[1] += 1e-2 * 1.25;
  EXPECT_FALSE(grid.coincides_with(shifted));
  VoxelGrid longer = grid;
  ++longer.size[2];
  EXPECT_FALSE(grid.coincides_with(longer));
  VoxelGrid wider = grid;
  wider.spacing[0] *= 1.001; // 8 voxels on, 0.008 voxels off
  EXPECT_FALSE(grid.coincides_with(wider));
  VoxelGrid mirrored = grid;
  mirrored.direction = -1. * grid.direction;
  EXPECT_FALSE(grid.coincides_with(mirrored));
}

} // namespace
} // namespace prosup::tests
