#include "prosup/phantom/chest_cylinder.h"

#include <gtest/gtest.h>

namespace prosup::tests {
namespace {

using dealii::Tensor;

TEST(ChestCylinder, HasTheNormalAndCurvatureOfItsDistance) {
  const phantom::Geometry geometry;
  const phantom::ChestCylinder chest(geometry);
  const Tensor<1, 3> x({33., 9., -7.});
  Tensor<1, 3> n, ahead, behind;
  EXPECT_NEAR(chest.distance(x, n), geometry.distance_to_chest(dealii::Point<3>(x)), 1e-12);
  const double h = 1e-4;
  for (unsigned d = 0; d < 3; ++d) {
    Tensor<1, 3> step;
    step[d] = h;
    const double slope =
        (chest.distance(x + step, ahead) - chest.distance(x - step, behind)) / (2. * h);
    EXPECT_NEAR(n[d], slope, 1e-7);
    for (unsigned c = 0; c < 3; ++c)
      EXPECT_NEAR(chest.curvature(x)[c][d], (ahead[c] - behind[c]) / (2. * h), 1e-7);
  }
}

} // namespace
} // namespace prosup::tests
