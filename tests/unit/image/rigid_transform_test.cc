#include "prosup/image/rigid_transform.h"

#include <gtest/gtest.h>

#include <cmath>

namespace prosup::tests {
namespace {

using namespace prosup::image;

/// A quarter turn about z through (1, 0, 0), and up by 5 mm.
RigidTransform quarter_turn() {
  RigidTransform transform;
  transform.rotation = rotation_about(Tensor<1, 3>({0., 0., std::acos(-1.) / 2.}));
  transform.centre = Point<3>(1., 0., 0.);
  transform.translation = Tensor<1, 3>({0., 0., 5.});
  return transform;
}

TEST(RigidTransform, TurnsAboutItsCentre) {
  const RigidTransform turn = quarter_turn();
  EXPECT_LT(turn(Point<3>(1., 0., 0.)).distance(Point<3>(1., 0., 5.)), 1e-12);
  EXPECT_LT(turn(Point<3>(3., 0., 0.)).distance(Point<3>(1., 2., 5.)), 1e-12);
}

TEST(RigidTransform, InverseAndComposition) {
  const RigidTransform turn = quarter_turn();
  const Point<3> x(4., -2., 7.);
  EXPECT_LT(turn.inverse()(turn(x)).distance(x), 1e-12);
  RigidTransform other;
  other.rotation = rotation_about(Tensor<1, 3>({0.3, -0.2, 0.1}));
  other.centre = Point<3>(-8., 3., 2.);
  other.translation = Tensor<1, 3>({1., 2., 3.});
  EXPECT_LT(compose(other, turn)(x).distance(other(turn(x))), 1e-12);
}

TEST(RigidTransform, RotationVectorIsTheOneItWasMadeOf) {
  const Tensor<1, 3> vector({0.02, -0.3, 0.1});
  RigidTransform transform;
  EXPECT_EQ(transform.rotation_vector().norm(), 0.);
  transform.rotation = rotation_about(vector);
  EXPECT_LT((transform.rotation_vector() - vector).norm(), 1e-12);
}

TEST(RigidTransform, MovesTheVoxelsOfAGrid) {
  VoxelGrid grid;
  grid.size = {4, 5, 6};
  grid.origin = Point<3>(-3., 2., 1.);
  grid.spacing = Tensor<1, 3>({1., 2., 3.});
  const RigidTransform turn = quarter_turn();
  EXPECT_LT(turn(grid).physical(2., 3., 4.).distance(turn(grid.physical(2., 3., 4.))), 1e-12);
}

} // namespace
} // namespace prosup::tests
