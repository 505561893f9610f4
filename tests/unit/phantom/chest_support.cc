#include "prosup/phantom/chest_support.h"

#include <gtest/gtest.h>

using namespace prosup::phantom;
using dealii::Tensor;

namespace {

const Tensor<1, 3> X({30., 4., -12.}), x({33., 9., -7.});

ChestSupport support() {
  return ChestSupport(Geometry(), {0., 2.5}, 1000., 8.);
}

Tensor<1, 3> force(const Tensor<1, 3>& X_, const Tensor<1, 3>& x_) {
  Tensor<1, 3> f;
  Tensor<2, 3> by_x, by_X;
  EXPECT_TRUE(support().evaluate(1, X_, x_, f, by_x, by_X));
  return f;
}

} // namespace

TEST(ChestSupport, ActsOnNodesOfTheChestOnly) {
  Tensor<1, 3> f;
  Tensor<2, 3> by_x, by_X;
  EXPECT_FALSE(support().evaluate(0, X, x, f, by_x, by_X));
  EXPECT_LT(force(X, X).norm(), 1e-9);
}

TEST(ChestSupport, TangentsAreTheDerivativesOfTheForce) {
  Tensor<1, 3> f;
  Tensor<2, 3> by_x, by_X;
  support().evaluate(1, X, x, f, by_x, by_X);
  const double h = 1e-5;
  for (unsigned d = 0; d < 3; ++d) {
    Tensor<1, 3> step;
    step[d] = h;
    const Tensor<1, 3> column_x = (force(X, x + step) - force(X, x - step)) / (2. * h);
    const Tensor<1, 3> column_X = (force(X + step, x) - force(X - step, x)) / (2. * h);
    for (unsigned c = 0; c < 3; ++c) {
      EXPECT_NEAR(by_x[c][d], column_x[c], 1e-4);
      EXPECT_NEAR(by_X[c][d], column_X[c], 1e-4);
    }
  }
}

// Along the axis and around it only the springs act: 8 Pa/mm on 2.5 mm^2.
TEST(ChestSupport, SlidesOnTheCylinder) {
  const Tensor<1, 3> along({X[0], X[1], X[2] + 3.});
  EXPECT_NEAR(force(X, along)[2], -8. * 2.5 * 3., 1e-9);
  EXPECT_NEAR(force(X, along)[0], 0., 1e-9);
  const Tensor<1, 3> mirrored({-X[0], X[1], X[2]}); // at the same distance to the axis
  EXPECT_NEAR(force(X, mirrored)[0], 8. * 2.5 * 60., 1e-9);
}
