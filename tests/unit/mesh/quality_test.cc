#include "prosup/mesh/quality.h"

#include <gtest/gtest.h>

#include "box_of_tets.h"
#include "expect_error.h"

namespace prosup::tests {
namespace {

using namespace prosup::mesh;

using Corners = std::array<Point<3>, 4>;

// Edge length sqrt(8).
const Corners regular{Point<3>(1., 1., 1.), Point<3>(-1., -1., 1.), Point<3>(1., -1., -1.),
                      Point<3>(-1., 1., -1.)};
const Corners corner{Point<3>(), Point<3>(1., 0., 0.), Point<3>(0., 1., 0.), Point<3>(0., 0., 1.)};

TEST(Quality, RadiusRatioOfKnownTetrahedra) {
  EXPECT_NEAR(std::abs(radius_ratio(regular)), 1., 1e-12);
  // r = 1/(3 + sqrt 3), R = sqrt(3)/2.
  EXPECT_NEAR(radius_ratio(corner), 6. / (3. * std::sqrt(3.) + 3.), 1e-12);
  const Corners inverted{corner[0], corner[2], corner[1], corner[3]};
  EXPECT_NEAR(radius_ratio(inverted), -radius_ratio(corner), 1e-12);
  const Corners flat{Point<3>(), Point<3>(1., 0., 0.), Point<3>(0., 1., 0.), Point<3>(1., 1., 0.)};
  EXPECT_NEAR(radius_ratio(flat), 0., 1e-12);
}

TEST(Quality, HeightAndVolumeOfKnownTetrahedra) {
  EXPECT_NEAR(min_height(regular), std::sqrt(8.) * std::sqrt(2. / 3.), 1e-12);
  EXPECT_NEAR(min_height(corner), 1. / std::sqrt(3.), 1e-12);
  EXPECT_NEAR(tet_volume(corner[0], corner[1], corner[2], corner[3]), 1. / 6., 1e-15);
  EXPECT_NEAR(tet_volume(corner[0], corner[2], corner[1], corner[3]), -1. / 6., 1e-15);
}

TEST(Quality, OfABoxOfEqualTets) {
  const TetMesh box = box_of_tets(Point<3>(), Point<3>(6., 6., 6.), 3, 0.);
  const MeshQuality quality = measure_quality(box);
  EXPECT_EQ(quality.n_cells, 162u);
  EXPECT_EQ(quality.n_nodes, 64u);
  EXPECT_NEAR(quality.volume_mm3, 216., 1e-9);
  EXPECT_NEAR(quality.min_quality, quality.mean_quality, 1e-12);
  EXPECT_NEAR(quality.min_edge, 2., 1e-12);
  EXPECT_NEAR(quality.mean_edge, 2. * (3. + 2. * std::sqrt(2.) + std::sqrt(3.)) / 6., 1e-12);
  EXPECT_NEAR(quality.min_height, std::sqrt(2.), 1e-12);
  EXPECT_NEAR(quality.max_aspect, 2. * std::sqrt(3.) / std::sqrt(2.), 1e-9);
  EXPECT_EQ(quality.fraction_below_02, 0.);
}

TEST(Quality, OfAMeshWithoutCellsIsAnError) {
  expect_error([] { measure_quality(TetMesh()); }, {"without cells"});
}

} // namespace
} // namespace prosup::tests
