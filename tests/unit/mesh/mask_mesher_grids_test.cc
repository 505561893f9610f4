#include <gtest/gtest.h>

#include <algorithm>

#include "expect_error.h"
#include "prosup/mesh/mask_mesher.h"
#include "prosup/mesh/quality.h"
#include "test_labels.h"

namespace prosup::tests {
namespace {

using namespace prosup::mesh;

using dealii::Tensor;

/// Turned by 30 degrees about z and 20 degrees about x; mirrored if `sign` is -1.
Tensor<2, 3> oblique(double sign) {
  const double a = M_PI / 6., b = M_PI / 9.;
  const Tensor<2, 3> about_z(
      {{std::cos(a), -std::sin(a), 0.}, {std::sin(a), std::cos(a), 0.}, {0., 0., 1.}});
  const Tensor<2, 3> about_x(
      {{1., 0., 0.}, {0., std::cos(b), -std::sin(b)}, {0., std::sin(b), std::cos(b)}});
  const Tensor<2, 3> mirror({{sign, 0., 0.}, {0., 1., 0.}, {0., 0., 1.}});
  return about_x * about_z * mirror;
}

class MaskMesherGrids : public ::testing::TestWithParam<double> {};

// A ball below the plane y = 8 (physical), chest label on the other side, on thick
// oblique slices: all in physical space, cells positive whatever the handedness.
TEST_P(MaskMesherGrids, ThickObliqueSlicesMeshInPhysicalSpace) {
  constexpr double radius = 24., plane = 8.;
  const auto grid = centred_grid({64, 64, 22}, Tensor<1, 3>({1., 1., 3.}), oblique(GetParam()));
  const Labels label_values;
  MaskMesher mesher(label_values);
  mesher.edge_length = 7.;
  const TetMesh mesh = mesher.mesh(make_labels(grid, [](const Point<3>& x) {
    return x.norm() > radius ? 0u : x[1] > plane ? 1u : 2u;
  }));
  const double cap = radius - plane;
  const double volume = ball_volume(radius) - M_PI * cap * cap * (radius - cap / 3.);
  const double disc = M_PI * (radius * radius - plane * plane);
  EXPECT_NEAR(measure_quality(mesh).volume_mm3, volume, 0.015 * volume);
  EXPECT_GT(measure_quality(mesh).min_quality, 0.2);
  // The rim, where chest and skin meet, is rounded by the smoothing.
  EXPECT_NEAR(area_of(mesh, BoundaryPart::chest_wall), disc, 0.12 * disc);
  double mean = 0.;
  std::size_t n = 0;
  for (const BoundaryFace& face : mesh.boundary_faces)
    for (const unsigned node : face.nodes) {
      const Point<3>& x = mesh.points[node];
      mean += std::min(std::abs(x.norm() - radius), std::abs(x[1] - plane));
      ++n;
      EXPECT_LT(x[1], plane + 1.5);
    }
  // Half of the in-plane spacing.
  EXPECT_LT(mean / double(n), 0.5);
}

INSTANTIATE_TEST_SUITE_P(Handedness, MaskMesherGrids, ::testing::Values(1., -1.));

TEST(MaskMesherMapping, MovesWithItsGrid) {
  const auto at_origin = ball_labels(centred_cube(36), 14.);
  auto moved = at_origin;
  moved.grid.direction = oblique(1.);
  moved.grid.origin = Point<3>(100., -20., 7.);
  const Labels label_values;
  MaskMesher mesher(label_values);
  mesher.edge_length = 7.;
  const TetMesh a = mesher.mesh(at_origin), b = mesher.mesh(moved);
  ASSERT_EQ(a.points.size(), b.points.size());
  for (std::size_t i = 0; i < a.points.size(); ++i) {
    const Point<3> index = at_origin.grid.continuous_index(a.points[i]);
    EXPECT_LT(b.points[i].distance(moved.grid.physical(index[0], index[1], index[2])), 1e-9);
  }
}

TEST(MaskMesherErrors, SayWhatIsMissing) {
  Labels label_values;
  MaskMesher mesher(label_values);
  const image::LabelImage empty(centred_cube(10), 1);
  expect_error([&] { mesher.mesh(empty); }, {"2, 3", "Labels/Tissues"});
  label_values.tissues = {7};
  const auto ball = ball_labels(centred_cube(20), 8.);
  expect_error([&] { mesher.mesh(ball); }, {"Labels/Gland", "3"});
  label_values.gland = 0;
  expect_error([&] { mesher.mesh(ball); }, {"7"});
}

TEST(MaskMesherErrors, BreastMustNotBeSmallerThanAnEdge) {
  const Labels label_values;
  MaskMesher mesher(label_values);
  mesher.edge_length = 20.;
  expect_error([&] { mesher.mesh(ball_labels(centred_cube(20), 5.)); },
               {"20 mm", "smaller \"Meshing/Edge length\""});
  image::LabelImage one_voxel(centred_cube(20));
  one_voxel(10, 10, 10) = 2;
  expect_error([&] { mesher.mesh(one_voxel); }, {"0.001 ml"});
}

} // namespace
} // namespace prosup::tests
