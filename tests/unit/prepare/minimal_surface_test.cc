#include "prepare/minimal_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace prosup::tests {
namespace {

using prepare::minimal_surface;
using prepare::SurfaceCosts;

double energy(const SurfaceCosts& costs, const std::vector<std::size_t>& levels, double slope,
              double largest) {
  double sum = 0.;
  for (std::size_t c = 0; c < costs.n_columns; ++c) {
    sum += double(costs.at(0, c)[levels[c]]);
    if (c > 0)
      sum += std::min(slope * std::abs(double(levels[c]) - double(levels[c - 1])), largest);
  }
  return sum;
}

// On a chain, belief propagation is exact: no other choice of levels costs less.
TEST(MinimalSurface, IsTheBestOfAllOnAChain) {
  constexpr std::size_t n_columns = 5, n_levels = 4;
  std::mt19937 generator(3);
  std::uniform_real_distribution<float> cost(0.f, 1.f);
  for (unsigned trial = 0; trial < 20; ++trial) {
    SurfaceCosts costs(1, n_columns, n_levels);
    for (float& value : costs.values)
      value = cost(generator);
    const double found = energy(costs, minimal_surface(costs, 0.2f, 0.5f, 2), 0.2, 0.5);
    double best = std::numeric_limits<double>::max();
    for (std::size_t code = 0; code < 1024; ++code) { // 4^5 choices
      std::vector<std::size_t> levels;
      for (std::size_t c = 0, rest = code; c < n_columns; ++c, rest /= n_levels)
        levels.push_back(rest % n_levels);
      best = std::min(best, energy(costs, levels, 0.2, 0.5));
    }
    EXPECT_NEAR(found, best, 1e-5);
  }
}

TEST(MinimalSurface, BridgesColumnsThatKnowNothing) {
  SurfaceCosts costs(9, 9, 20);
  for (std::size_t r = 0; r < 9; ++r)
    for (std::size_t c = 0; c < 9; ++c)
      for (std::size_t l = 0; l < 20; ++l)
        costs.at(r, c)[l] = r > 2 && r < 6 && c > 2 && c < 6 ? 0.f : l == 7 ? -1.f : 0.f;
  for (const std::size_t level : minimal_surface(costs, 0.05f, 1.f, 4))
    EXPECT_EQ(level, 7u);
}

TEST(MinimalSurface, FollowsAStepThatIsWorthIt) {
  SurfaceCosts costs(3, 10, 30);
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 10; ++c)
      costs.at(r, c)[c < 5 ? 5 : 25] = -1.f;
  const auto levels = minimal_surface(costs, 0.1f, 0.5f, 4);
  for (std::size_t c = 0; c < 10; ++c)
    EXPECT_EQ(levels[10 + c], c < 5 ? 5u : 25u);
}

} // namespace
} // namespace prosup::tests
