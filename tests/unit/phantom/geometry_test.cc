#include "prosup/phantom/geometry.h"

#include "expect_error.h"

namespace prosup::tests {
namespace {

using namespace prosup::phantom;

TEST(Geometry, HasTheVolumeOfItsThickness) {
  Geometry geometry;
  geometry.sigma = 30.;
  geometry.length = 90.;
  double sum = 0.;
  const double h = 0.5;
  for (double x = -0.5 * geometry.width + 0.5 * h; x < 0.5 * geometry.width; x += h)
    for (double z = -0.5 * geometry.length + 0.5 * h; z < 0.5 * geometry.length; z += h)
      for (double y = geometry.skin_y(0., 0.); y < geometry.chest_y(0.5 * geometry.width); y += 1.)
        sum += geometry.in_tissue({x, y, z}) ? h * h * 1. : 0.;
  EXPECT_NEAR(sum / geometry.volume(), 1., 5e-3);
}

TEST(Geometry, OfTheDefaultsIsThatOfThePaper) {
  const Geometry geometry;
  EXPECT_NEAR(geometry.volume() / 1e6, 1.14, 0.01);                                         // l
  EXPECT_NEAR(geometry.chest_y(0.5 * geometry.width) - geometry.skin_y(0., 0.), 137.8, 1.); // mm
}

TEST(Geometry, KnowsWhatIsInFrontOfTheChest) {
  const Geometry geometry;
  EXPECT_TRUE(geometry.in_tissue({0., -1., 0.}));
  EXPECT_FALSE(geometry.in_tissue({0., 1., 0.}));
  EXPECT_FALSE(geometry.in_tissue({0., -108., 0.}));
  EXPECT_FALSE(geometry.in_tissue({81., 30., 0.}));
  EXPECT_NEAR(geometry.distance_to_chest({0., -10., 40.}), 10., 1e-12);
  EXPECT_NEAR(geometry.distance_to_chest(geometry.on_chest({50., 3., 4.})), 0., 1e-12);
}

TEST(Geometry, RefusesAChestNarrowerThanTheTissue) {
  Geometry geometry;
  geometry.chest_radius = 80.;
  expect_error([&] { geometry.check(); }, {"Chest radius", "80", "160.4"});
}

} // namespace
} // namespace prosup::tests
