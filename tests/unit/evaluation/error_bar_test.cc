#include "prosup/evaluation/error_bar.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "affine_mesh.h"
#include "expect_error.h"

namespace prosup::tests {
namespace {

using namespace dealii;
using namespace prosup::evaluation;

Covariance diagonal(double x, double y, double z) {
  Covariance covariance;
  covariance[0][0] = x;
  covariance[1][1] = y;
  covariance[2][2] = z;
  return covariance;
}

TEST(ErrorBar, RadiusOfEqualErrorsAlongALineInAPlaneAndInSpace) {
  EXPECT_NEAR(error_bar(diagonal(4., 0., 0.)).radius_95, 2. * 1.960, 0.01);
  EXPECT_NEAR(error_bar(diagonal(0., 4., 4.)).radius_95, 2. * 2.448, 0.01);
  EXPECT_NEAR(error_bar(diagonal(4., 4., 4.)).radius_95, 2. * 2.795, 0.01);
  EXPECT_EQ(error_bar(Covariance()).radius_95, 0.);
  const ErrorBar bar = error_bar(diagonal(1., 4., 9.));
  EXPECT_EQ(bar.deviation, (Tensor<1, 3>({1., 2., 3.})));
}

// Errors that differ between the axes: 95 % of random ones are within the radius.
TEST(ErrorBar, RadiusHoldsNinetyFivePercent) {
  std::mt19937 engine(1);
  std::normal_distribution<double> normal;
  for (const Tensor<1, 3>& sd :
       {Tensor<1, 3>({1., 2., 3.}), Tensor<1, 3>({1., 1., 4.}), Tensor<1, 3>({0.2, 3., 3.})}) {
    const double radius =
        error_bar(diagonal(sd[0] * sd[0], sd[1] * sd[1], sd[2] * sd[2])).radius_95;
    constexpr unsigned n = 20000;
    unsigned n_within = 0;
    for (unsigned i = 0; i < n; ++i) {
      const Tensor<1, 3> error(
          {sd[0] * normal(engine), sd[1] * normal(engine), sd[2] * normal(engine)});
      n_within += error.norm() < radius;
    }
    EXPECT_NEAR(double(n_within) / n, 0.95, 0.007) << sd;
  }
}

struct AffinePair {
  PerPosition<mesh::UnloadedMesh> meshes{
      affine_mesh(box_of_tets({-20., -20., -20.}, {20., 20., 20.}, 3), stretch_and_shear()),
      affine_mesh(box_of_tets({-20., -20., -20.}, {20., 20., 20.}, 4), other_stretch_and_shear())};
  PointMapper prone{meshes.prone}, supine{meshes.supine};

  Uncertainty::Covariances constant(const Covariance& covariance) const {
    return {std::vector<Covariance>(meshes.prone.unloaded.size(), covariance),
            std::vector<Covariance>(meshes.supine.unloaded.size(), covariance)};
  }
};

TEST(Uncertainty, TurnsAndStretchesWithTheTarget) {
  const AffinePair pair;
  const Covariance covariance = diagonal(1., 2., 3.);
  const Uncertainty uncertainty(pair.prone, pair.supine, pair.constant(covariance));
  for (const Point<3>& X : {Point<3>(1., 2., 3.), Point<3>(-4., 0., 5.)}) {
    EXPECT_LT((uncertainty.unloaded(X) - covariance).norm(), 1e-12);
    Tensor<2, 3> F; // by differences
    for (unsigned d = 0; d < 3; ++d) {
      Point<3> moved = X;
      moved[d] += 1.;
      const Tensor<1, 3> column = pair.supine.to_loaded(moved) - pair.supine.to_loaded(X);
      for (unsigned c = 0; c < 3; ++c)
        F[c][d] = column[c];
    }
    const Tensor<2, 3> expected = F * Tensor<2, 3>(covariance) * transpose(F);
    EXPECT_LT((Tensor<2, 3>(uncertainty.loaded(X, Position::supine)) - expected).norm(), 1e-9);
  }
}

TEST(Uncertainty, OutsideTakesTheClosestPointOfTheSurface) {
  const AffinePair pair;
  Uncertainty::Covariances covariances = pair.constant(diagonal(1., 1., 1.));
  for (const Position position : both_positions)
    for (std::size_t node = 0; node < covariances[position].size(); ++node)
      covariances[position][node] *= 30. + pair.meshes[position].unloaded[node][0];
  const Uncertainty uncertainty(pair.prone, pair.supine, covariances);
  EXPECT_NEAR(uncertainty.unloaded(Point<3>(5., 1., 2.))[0][0], 35., 1e-9);
  EXPECT_NEAR(uncertainty.unloaded(Point<3>(29., 1., 2.))[0][0], 50., 1e-9);
}

TEST(Uncertainty, RefusesWhatIsNoCovariance) {
  const AffinePair pair;
  auto covariances = pair.constant(diagonal(1., 1., 1.));
  covariances.supine.pop_back();
  expect_error([&] { Uncertainty(pair.prone, pair.supine, covariances); }, {"supine", "each"});
  for (const double wrong : {-1., std::numeric_limits<double>::quiet_NaN()}) {
    covariances = pair.constant(diagonal(1., 1., 1.));
    covariances.prone[7][1][1] = wrong;
    expect_error([&] { Uncertainty(pair.prone, pair.supine, covariances); }, {"prone", "finite"});
  }
}

} // namespace
} // namespace prosup::tests
