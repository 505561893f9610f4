#include "prosup/evaluation/depth.h"

#include <gtest/gtest.h>

namespace prosup::tests {
namespace {

using dealii::Point;
using mesh::BoundaryPart;

/// A corner of a cube with edges of 10 mm: skin in the plane x = 0, the chest wall in y = 0.
mesh::TetMesh corner() {
  mesh::TetMesh mesh;
  mesh.points = {{0., 0., 0.}, {10., 0., 0.}, {0., 10., 0.}, {0., 0., 10.}};
  mesh.cells = {{0, 1, 2, 3}};
  mesh.tissue = {2};
  mesh.boundary_faces = {{{0, 3, 2}, BoundaryPart::skin},
                         {{0, 1, 3}, BoundaryPart::chest_wall},
                         {{0, 2, 1}, BoundaryPart::cut_plane}};
  return mesh;
}

TEST(Depth, IsTheDistanceToTheFacesOfEachPart) {
  const mesh::TetMesh mesh = corner();
  const evaluation::DepthGauge gauge(mesh, mesh.points);
  const evaluation::Depth inside = gauge({2., 3., 1.});
  EXPECT_NEAR(inside.skin.value(), 2., 1e-12);
  EXPECT_NEAR(inside.chest_wall.value(), 3., 1e-12);
  // Beyond the end of a part it is the distance from its edge.
  EXPECT_NEAR(gauge({0., -3., -4.}).skin.value(), 5., 1e-12);
}

TEST(Depth, IsThatOfTheGivenPositions) {
  const mesh::TetMesh mesh = corner();
  std::vector<Point<3>> moved = mesh.points;
  for (Point<3>& point : moved)
    point[0] += 7.;
  EXPECT_NEAR(evaluation::DepthGauge(mesh, moved)({9., 3., 1.}).skin.value(), 2., 1e-12);
}

TEST(Depth, IsUnknownForAPartThatIsNotThere) {
  mesh::TetMesh mesh = corner();
  mesh.boundary_faces.resize(1);
  const evaluation::Depth depth = evaluation::DepthGauge(mesh, mesh.points)({1., 1., 1.});
  EXPECT_TRUE(depth.skin.has_value());
  EXPECT_FALSE(depth.chest_wall.has_value());
  EXPECT_FALSE(evaluation::tip_of(mesh).has_value());
}

TEST(Depth, TipIsTheSkinFurthestFromTheChest) {
  EXPECT_EQ(evaluation::tip_of(corner()).value(), Point<3>(0., 10., 0.));
}

} // namespace
} // namespace prosup::tests
