#include "prosup/mesh/scan_conversion.h"

#include <gtest/gtest.h>

#include <limits>

#include "box_of_tets.h"

namespace prosup::tests {
namespace {

using dealii::Point;
using dealii::Tensor;
using image::VoxelGrid;

VoxelGrid oblique_grid(double handedness) {
  VoxelGrid grid;
  grid.size = {40, 36, 32};
  grid.spacing = Tensor<1, 3>({0.8, 1.0, 1.3});
  const double c = std::cos(0.5), s = std::sin(0.5);
  grid.direction = Tensor<2, 3>({{c, -s, 0.}, {s, c, 0.}, {0., 0., handedness}});
  grid.origin = Point<3>(-6., -20., handedness > 0. ? -20. : 20.);
  return grid;
}

Point<3> centre(const VoxelGrid& grid, std::size_t i, std::size_t j, std::size_t k) {
  const Tensor<1, 3> steps({grid.spacing[0] * static_cast<double>(i),
                            grid.spacing[1] * static_cast<double>(j),
                            grid.spacing[2] * static_cast<double>(k)});
  return grid.origin + grid.direction * steps;
}

std::array<Point<3>, 4> corners_of(const mesh::TetMesh& mesh, std::size_t cell) {
  std::array<Point<3>, 4> corners;
  for (unsigned a = 0; a < 4; ++a)
    corners[a] = mesh.points[mesh.cells[cell][a]];
  return corners;
}

std::vector<int> count_visits(const VoxelGrid& grid, const mesh::TetMesh& mesh) {
  std::vector<int> visits(grid.n_voxels(), 0);
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
    mesh::scan_convert_tet(grid, corners_of(mesh, cell),
                           [&](auto i, auto j, auto k, const std::array<double, 4>&) {
                             ++visits[grid.linear_index(i, j, k)];
                           });
  return visits;
}

class ScanConversion : public ::testing::TestWithParam<double> {};

// Every centre in the box is found, none outside, and hardly one twice.
TEST_P(ScanConversion, CoversABoxWithoutGaps) {
  const VoxelGrid grid = oblique_grid(GetParam());
  const Point<3> low(-7.1, -6.3, -8.2), high(8.3, 9.1, 7.7);
  const std::vector<int> visits = count_visits(grid, box_of_tets(low, high, 5));
  std::size_t n_inside = 0;
  for (std::size_t k = 0; k < grid.size[2]; ++k)
    for (std::size_t j = 0; j < grid.size[1]; ++j)
      for (std::size_t i = 0; i < grid.size[0]; ++i) {
        const Point<3> p = centre(grid, i, j, k);
        bool inside = true;
        for (unsigned d = 0; d < 3; ++d)
          inside = inside && p[d] > low[d] && p[d] < high[d];
        n_inside += inside;
        ASSERT_EQ(visits[grid.linear_index(i, j, k)], inside ? 1 : 0) << p;
      }
  EXPECT_GT(n_inside, 3000u);
}

TEST_P(ScanConversion, WeightsReproduceTheVoxelCentre) {
  const VoxelGrid grid = oblique_grid(GetParam());
  const auto box = box_of_tets(Point<3>(-7.1, -6.3, -8.2), Point<3>(8.3, 9.1, 7.7), 3);
  double largest_error = 0.;
  std::size_t n_visits = 0;
  for (std::size_t cell = 0; cell < box.cells.size(); ++cell) {
    const auto corners = corners_of(box, cell);
    mesh::scan_convert_tet(grid, corners, [&](auto i, auto j, auto k, const auto& weights) {
      Point<3> p;
      for (unsigned a = 0; a < 4; ++a) {
        EXPECT_GE(weights[a], -1e-8);
        p += weights[a] * Tensor<1, 3>(corners[a]);
      }
      largest_error = std::max(largest_error, p.distance(centre(grid, i, j, k)));
      ++n_visits;
    });
  }
  EXPECT_GT(n_visits, 3000u);
  EXPECT_LT(largest_error, 1e-11);
}

INSTANTIATE_TEST_SUITE_P(RightAndLeftHanded, ScanConversion, ::testing::Values(1., -1.));

// Centres on faces, edges and nodes belong to all neighbours, so none is lost.
TEST(ScanConversionOnFaces, CentresOnSharedFacesAreVisited) {
  VoxelGrid grid;
  grid.size = {9, 9, 9};
  const auto box = box_of_tets(Point<3>(0., 0., 0.), Point<3>(8., 8., 8.), 4, 0.);
  for (const int n : count_visits(grid, box))
    ASSERT_GE(n, 1);
}

TEST(ScanConversionOnFaces, ThinTetsLeaveNoGap) {
  VoxelGrid grid;
  grid.size = {7, 7, 7};
  // Two layers share the plane z = 3, on which centres lie; the upper is 1e-5 thick.
  mesh::TetMesh box = box_of_tets(Point<3>(-1, -1, -1), Point<3>(7, 7, 7), 2, 0.);
  for (auto& p : box.points)
    p[2] = p[2] == 3. ? 3. : p[2] == 7. ? 3. + 1e-5 : p[2];
  const std::vector<int> visits = count_visits(grid, box);
  for (std::size_t index = 0; index < 4 * 49; ++index) // the layers z = 0 to 3
    ASSERT_GE(visits[index], 1) << index;
  for (std::size_t index = 4 * 49; index < visits.size(); ++index)
    ASSERT_EQ(visits[index], 0) << index;
}

TEST(ScanConversionOfBadTets, FlatInvertedAndNonFiniteAreSkipped) {
  VoxelGrid grid;
  grid.size = {8, 8, 8};
  const Point<3> a(1, 1, 1), b(6, 1, 1), c(1, 6, 1), d(1, 1, 6);
  std::size_t n = 0;
  const auto count = [&n](auto, auto, auto, const auto&) { ++n; };
  mesh::scan_convert_tet(grid, {a, c, b, d}, count);
  mesh::scan_convert_tet(grid, {a, b, c, Point<3>(3, 3, 1)}, count);
  mesh::scan_convert_tet(grid, {a, b, c, Point<3>(1, 1, std::numeric_limits<double>::quiet_NaN())},
                         count);
  EXPECT_EQ(n, 0u);
  mesh::scan_convert_tet(grid, {a, b, c, d}, count);
  EXPECT_EQ(n, 56u); // 5 + 1 points along an edge: C(8, 3)
}

TEST(ScanConversionOfBadTets, PartsOutsideTheGridAreClipped) {
  VoxelGrid grid;
  grid.size = {4, 4, 4};
  std::size_t n = 0;
  const auto count = [&n](auto, auto, auto, const auto&) { ++n; };
  mesh::scan_convert_tet(grid,
                         {Point<3>(-90, -90, -90), Point<3>(500, -90, -90), Point<3>(-90, 500, -90),
                          Point<3>(-90, -90, 500)},
                         count);
  EXPECT_EQ(n, 64u);
  mesh::scan_convert_tet(
      grid,
      {Point<3>(10, 10, 10), Point<3>(20, 10, 10), Point<3>(10, 20, 10), Point<3>(10, 10, 20)},
      count);
  EXPECT_EQ(n, 64u);
}

} // namespace
} // namespace prosup::tests
