#include <gtest/gtest.h>

#include <algorithm>

#include "image/axis_order.h"
#include "test_grids.h"

namespace prosup::tests {
namespace {

using namespace prosup::image;

/// The same voxels with the axes in another order, and some of them turned round.
ScalarImage stored_otherwise(const ScalarImage& image, const std::array<unsigned, 3>& order,
                             unsigned turned) {
  VoxelGrid grid;
  std::array<double, 3> first{0., 0., 0.};
  for (unsigned d = 0; d < 3; ++d) {
    const bool turn = (turned >> d & 1u) != 0;
    grid.size[d] = image.grid.size[order[d]];
    grid.spacing[d] = image.grid.spacing[order[d]];
    for (unsigned e = 0; e < 3; ++e)
      grid.direction[e][d] = (turn ? -1. : 1.) * image.grid.direction[e][order[d]];
    first[order[d]] = turn ? double(grid.size[d] - 1) : 0.;
  }
  grid.origin = image.grid.physical(first[0], first[1], first[2]);
  ScalarImage result(grid);
  for_each_voxel(grid, [&](std::size_t voxel, const Point<3>& x) {
    const Point<3> index = image.grid.continuous_index(x);
    result.values[voxel] = image(std::size_t(index[0] + 0.5), std::size_t(index[1] + 0.5),
                                 std::size_t(index[2] + 0.5));
  });
  return result;
}

TEST(AxisOrder, IsTheUsualOneHoweverAFileHasIt) {
  const ScalarImage usual = random_image(oblique_grid());
  std::array<unsigned, 3> order{0, 1, 2};
  do {
    for (unsigned turned = 0; turned < 8; ++turned) {
      ScalarImage stored = stored_otherwise(usual, order, turned);
      // Front and back stay as they are, and left and right follow.
      unsigned of_front = 0;
      while (order[of_front] != 1)
        ++of_front;
      const bool back = (turned >> of_front & 1u) != 0;
      const ScalarImage expected = back ? stored_otherwise(usual, {0, 1, 2}, 3) : usual;
      const ScalarImage found = in_usual_order(stored);
      EXPECT_TRUE(found.grid.coincides_with(expected.grid, 1e-9));
      EXPECT_EQ(found.values, expected.values);
    }
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST(AxisOrder, LeavesWhatIsInOrder) {
  for (const VoxelGrid& grid : {cube_grid(3), flipped_grid(), oblique_grid()}) {
    const ScalarImage image = random_image(grid);
    const ScalarImage found = in_usual_order(image);
    EXPECT_EQ(found.values, image.values);
    EXPECT_EQ(found.grid.origin, grid.origin);
  }
}

} // namespace
} // namespace prosup::tests
