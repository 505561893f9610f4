// The metric of examples/metric, as a host program would add it.
#include <gtest/gtest.h>

#include <numeric>

#include "../../../examples/metric/charbonnier.h"
#include "prosup/similarity/sum_of_squared_differences.h"
#include "warped_pairs.h"

namespace prosup::tests {
namespace {

TEST(ExampleMetric, SlopeIsTheDerivativeOfTheValue) {
  const Charbonnier metric;
  const auto shifted = [](const Point<3>& x) { return blobs(x + Point<3>(3., -2., 1.)); };
  const WarpedPair pair = warped_pair(blobs, shifted, 0.05);
  const auto direction = random_direction(pair.in_domain.size());
  VoxelDerivatives derivatives, unused;
  metric.evaluate(pair, derivatives);
  constexpr double step = 1e-3;
  for (const Position p : both_positions) {
    const double slope = (metric.evaluate(moved(pair, p, direction, step), unused) -
                          metric.evaluate(moved(pair, p, direction, -step), unused)) /
                         (2. * step);
    EXPECT_NEAR(
        std::inner_product(direction.begin(), direction.end(), derivatives.slope[p].begin(), 0.),
        slope, 3e-3 * std::abs(slope));
    EXPECT_GT(std::abs(slope), 1.);
  }
}

// Small differences count as in the SSD, large ones less.
TEST(ExampleMetric, IsTheSsdOfSmallDifferences) {
  VoxelDerivatives unused;
  const auto ratio = [&](double difference) {
    const WarpedPair pair =
        warped_pair(blobs, [difference](const Point<3>& x) { return blobs(x) + difference; });
    return Charbonnier().evaluate(pair, unused) /
           similarity::SumOfSquaredDifferences().evaluate(pair, unused);
  };
  EXPECT_NEAR(ratio(0.01), 1., 1e-3);
  EXPECT_LT(ratio(2.), 0.25);
}

} // namespace
} // namespace prosup::tests
