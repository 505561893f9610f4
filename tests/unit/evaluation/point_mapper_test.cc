#include "prosup/evaluation/point_mapper.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <thread>

#include "affine_mesh.h"
#include "expect_error.h"

namespace prosup::tests {
namespace {

using namespace prosup::evaluation;

const Point<3> low(-20., -15., -10.), high(20., 25., 30.);

std::vector<Point<3>> random_points(const Point<3>& from, const Point<3>& to, unsigned n) {
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> random(0., 1.);
  std::vector<Point<3>> points(n);
  for (auto& p : points)
    for (unsigned d = 0; d < 3; ++d)
      p[d] = from[d] + (to[d] - from[d]) * random(generator);
  return points;
}

/// A mesh whose deformation is not affine and bends its surface.
mesh::UnloadedMesh bent_mesh() {
  mesh::UnloadedMesh bent{box_of_tets(low, high, 8), {}};
  for (const auto& p : bent.mesh.points)
    bent.unloaded.push_back(
        p + dealii::Tensor<1, 3>(
                {2. * std::sin(p[1] / 9.), 3. * std::cos(p[2] / 11.), -2. * std::sin(p[0] / 8.)}));
  return bent;
}

TEST(PointMapper, IsExactForAnAffineMap) {
  const AffineMap affine = stretch_and_shear();
  const PointMapper mapper(affine_mesh(box_of_tets(low, high, 6), affine));
  for (const auto& X : random_points(low, high, 2000)) {
    EXPECT_LT(mapper.to_loaded(X).distance(affine(X)), 1e-10);
    EXPECT_LT(mapper.to_unloaded(affine(X)).distance(X), 1e-10);
    EXPECT_EQ(mapper.distance_outside(X, Configuration::unloaded), 0.);
  }
}

// Also outside, where it is that of the cell behind the closest face.
TEST(PointMapper, PlacesKnowTheVolumeRatio) {
  const AffineMap affine = stretch_and_shear();
  const PointMapper mapper(affine_mesh(box_of_tets(low, high, 4), affine));
  for (const auto& X : random_points(low - dealii::Tensor<1, 3>({5., 5., 5.}), high, 200))
    EXPECT_NEAR(mapper.place(X).volume_ratio, determinant(affine.A), 1e-10);
}

TEST(PointMapper, NodesEdgesAndFacesAreFound) {
  const AffineMap affine = stretch_and_shear();
  const auto box = box_of_tets(low, high, 4, 0.);
  const PointMapper mapper(affine_mesh(box, affine));
  for (const auto& cell : box.cells)
    for (const Point<3>& X :
         {box.points[cell[0]],
          box.points[cell[0]] + (box.points[cell[1]] - box.points[cell[0]]) / 3.,
          Point<3>((box.points[cell[1]] + dealii::Tensor<1, 3>(box.points[cell[2]]) +
                    dealii::Tensor<1, 3>(box.points[cell[3]])) /
                   3.)}) {
      EXPECT_LT(mapper.to_loaded(X).distance(affine(X)), 1e-9);
      EXPECT_LT(mapper.to_unloaded(affine(X)).distance(X), 1e-9);
    }
}

TEST(PointMapper, ThereAndBackReturnsThePoint) {
  const PointMapper mapper(bent_mesh());
  unsigned n_mapped = 0;
  for (const auto& x : random_points(low, high, 5000)) {
    const MappedPoint there = mapper.map(x, Configuration::loaded);
    EXPECT_EQ(there.distance_outside, 0.);
    EXPECT_LT(mapper.to_loaded(there.position).distance(x), 1e-6);
    n_mapped += there.position.distance(x) > 0.5;
  }
  EXPECT_GT(n_mapped, 4000u);
}

TEST(PointMapper, ContinuesWithoutAJumpAcrossTheSurface) {
  const PointMapper mapper(bent_mesh());
  for (Point<3> inside : random_points(low, high, 300))
    for (unsigned d = 0; d < 3; ++d) {
      Point<3> outside = inside;
      inside[d] = high[d] - 1e-7;
      outside[d] = high[d] + 1e-7;
      EXPECT_LT(mapper.to_unloaded(inside).distance(mapper.to_unloaded(outside)), 1e-6);
    }
}

// Above the middle of a flat side the closest point is the foot of the normal.
TEST(PointMapper, OutsideMovesWithTheClosestPoint) {
  const AffineMap affine = stretch_and_shear();
  const PointMapper mapper(affine_mesh(box_of_tets(low, high, 4), affine));
  const Point<3> foot(high[0], 3., 7.), above(high[0] + 12., 3., 7.);
  const MappedPoint mapped = mapper.map(above, Configuration::unloaded);
  EXPECT_NEAR(mapped.distance_outside, 12., 1e-9);
  EXPECT_LT(mapped.position.distance(above + (affine(foot) - foot)), 1e-9);
  EXPECT_NEAR(mapper.distance_outside(Point<3>(1e4, 3., 7.), Configuration::unloaded),
              1e4 - high[0], 1e-6);
}

TEST(PointMapper, OutsideThereAndBackReturnsThePoint) {
  const PointMapper mapper(bent_mesh());
  const dealii::Tensor<1, 3> margin({4., 4., 4.});
  unsigned n_outside = 0;
  for (const auto& x : random_points(low - margin, high + margin, 3000)) {
    const MappedPoint there = mapper.map(x, Configuration::loaded);
    EXPECT_LT(mapper.to_loaded(there.position).distance(x), 1e-3);
    n_outside += there.distance_outside > 1.;
  }
  EXPECT_GT(n_outside, 500u);
}

TEST(PointMapper, ThreadsMayAskAtOnce) {
  const PointMapper mapper(bent_mesh());
  const auto points = random_points(Point<3>(-25., -20., -15.), high, 4000);
  std::vector<Point<3>> serial, threaded(points.size());
  for (const auto& p : points)
    serial.push_back(mapper.to_unloaded(p));
  std::vector<std::thread> threads;
  for (unsigned t = 0; t < 4; ++t)
    threads.emplace_back([&, t] {
      for (std::size_t i = t; i < points.size(); i += 4)
        threaded[i] = mapper.to_unloaded(points[i]);
    });
  for (auto& thread : threads)
    thread.join();
  EXPECT_EQ(serial, threaded);
}

TEST(PointMapper, RefusesWhatItCannotMap) {
  auto mesh = bent_mesh();
  const double not_a_number = std::numeric_limits<double>::quiet_NaN();
  const PointMapper mapper(mesh);
  expect_error([&] { mapper.to_loaded(Point<3>(0., not_a_number, 0.)); }, {"not a finite number"});
  expect_error([] { PointMapper(mesh::UnloadedMesh{}); }, {"no cells"});
  mesh.unloaded[5][1] = not_a_number;
  expect_error([&] { PointMapper{mesh}; }, {"not finite"});
  mesh.unloaded.pop_back();
  expect_error([&] { PointMapper{mesh}; }, {"729 nodes", "728 unloaded"});
}

} // namespace
} // namespace prosup::tests
