#include "prosup/similarity/metric.h"

#include <gtest/gtest.h>

#include <numeric>

#include "expect_error.h"
#include "prosup/similarity/local_correlation.h"
#include "prosup/similarity/mutual_information.h"
#include "prosup/similarity/similarity_parameters.h"
#include "prosup/similarity/sum_of_squared_differences.h"
#include "warped_pairs.h"

namespace prosup::tests {
namespace {

double inner(const std::vector<float>& a, const std::vector<float>& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.);
}

double inverted(const Point<3>& x) {
  return 0.9 - 0.6 * blobs(x);
}

/// Air where one image has none: what an outline looks like.
double with_air(const Point<3>& x) {
  return x[1] > 34. ? -0.5 : 0.8 - 0.5 * blobs(x);
}

/// Pairs that are alike but for the contrast, unlike, and noisy.
std::vector<WarpedPair> pairs() {
  const auto shifted = [](const Point<3>& x) { return blobs(x + Point<3>(3., -2., 1.)); };
  return {warped_pair(blobs, inverted, 0.02), warped_pair(shifted, with_air, 0.05),
          warped_pair([](const Point<3>&) { return 0.4; }, blobs, 0.1)};
}

std::shared_ptr<const similarity::Metric> metric_named(const std::string& name) {
  similarity::SimilarityParameters parameters;
  parameters.metric = name;
  return parameters.make_metric();
}

class Metrics : public ::testing::TestWithParam<std::string> {
protected:
  double value(const WarpedPair& pair) const {
    VoxelDerivatives derivatives;
    return metric->evaluate(pair, derivatives);
  }
  const std::shared_ptr<const similarity::Metric> metric = metric_named(GetParam());
};

class MultimodalMetrics : public Metrics {};

INSTANTIATE_TEST_SUITE_P(All, Metrics, ::testing::ValuesIn(similarity::metric_names()),
                         [](const auto& info) { return info.param; });
INSTANTIATE_TEST_SUITE_P(All, MultimodalMetrics,
                         ::testing::ValuesIn(similarity::metric_names(true)),
                         [](const auto& info) { return info.param; });

TEST_P(Metrics, SlopeIsTheDerivativeOfTheValue) {
  const double step = 1e-3;
  for (const WarpedPair& pair : pairs()) {
    VoxelDerivatives derivatives;
    metric->evaluate(pair, derivatives);
    // Along the slope itself, and along noise that makes it bigger at no voxel.
    for (const Position p : both_positions) {
      std::vector<float> direction = random_direction(pair.in_domain.size());
      const double size = std::sqrt(inner(derivatives.slope[p], derivatives.slope[p]));
      for (std::size_t v = 0; v < direction.size(); ++v)
        direction[v] += static_cast<float>(50. / size) * derivatives.slope[p][v];
      const double slope =
          (value(moved(pair, p, direction, step)) - value(moved(pair, p, direction, -step))) /
          (2. * step);
      EXPECT_NEAR(inner(derivatives.slope[p], direction), slope, 3e-3 * std::abs(slope));
      EXPECT_GT(std::abs(slope), 1.);
    }
  }
}

TEST_P(Metrics, SlopeOfSingleVoxels) {
  const WarpedPair pair = pairs()[1];
  VoxelDerivatives derivatives;
  metric->evaluate(pair, derivatives);
  const double step = 0.01;
  for (const Position p : both_positions)
    for (const std::size_t v : {3000u, 6130u, 7001u}) {
      std::vector<float> direction(pair.in_domain.size(), 0.f);
      direction[v] = 1.f;
      const double slope =
          (value(moved(pair, p, direction, step)) - value(moved(pair, p, direction, -step))) /
          (2. * step);
      EXPECT_NEAR(derivatives.slope[p][v], slope, 0.02 * std::abs(slope) + 1e-3) << "voxel " << v;
    }
}

// In directions that are noise, the second derivative of the value is the sum of
// the curvatures: exactly for the ssd, which is quadratic, and to a factor of two
// for the others, of which the curvature is an expectation.
TEST_P(Metrics, CurvatureIsTheSecondDerivativeWhereTheImagesMatch) {
  const WarpedPair pair = metric->needs_same_contrast() ? warped_pair(blobs, blobs, 0.05)
                                                        : warped_pair(blobs, inverted, 0.05);
  VoxelDerivatives derivatives;
  metric->evaluate(pair, derivatives);
  const std::vector<float> direction = random_direction(pair.in_domain.size());
  const double step = 0.01;
  for (const Position p : both_positions) {
    double expected = 0.;
    for (std::size_t v = 0; v < direction.size(); ++v)
      expected += derivatives.curvature[p][v] * direction[v] * direction[v];
    const double second = (value(moved(pair, p, direction, step)) - 2. * value(pair) +
                           value(moved(pair, p, direction, -step))) /
                          (step * step);
    EXPECT_GT(expected, 0.5 * second);
    EXPECT_LT(expected, 2. * second);
  }
}

TEST_P(Metrics, NothingOutsideTheDomainAndNoNegativeCurvature) {
  for (const WarpedPair& pair : pairs()) {
    VoxelDerivatives derivatives;
    metric->evaluate(pair, derivatives);
    for (const Position p : both_positions)
      for (std::size_t v = 0; v < pair.in_domain.size(); ++v) {
        ASSERT_TRUE(std::isfinite(derivatives.slope[p][v]));
        ASSERT_TRUE(std::isfinite(derivatives.curvature[p][v]));
        ASSERT_GE(derivatives.curvature[p][v], 0.f);
        if (!pair.in_domain[v]) {
          ASSERT_EQ(derivatives.slope[p][v], 0.f);
          ASSERT_EQ(derivatives.curvature[p][v], 0.f);
        }
      }
  }
}

TEST_P(Metrics, SwappingTheImagesSwapsTheDerivatives) {
  const WarpedPair pair = pairs()[1];
  WarpedPair swapped = pair;
  std::swap(swapped.values.prone, swapped.values.supine);
  VoxelDerivatives a, b;
  const double value = metric->evaluate(pair, a);
  EXPECT_NEAR(metric->evaluate(swapped, b), value, 1e-9 * value);
  for (const Position p : both_positions)
    for (std::size_t v = 0; v < pair.in_domain.size(); ++v) {
      ASSERT_NEAR(a.slope[p][v], b.slope[other(p)][v], 1e-5 * std::abs(a.slope[p][v]) + 1e-9);
      ASSERT_NEAR(a.curvature[p][v], b.curvature[other(p)][v], 1e-5 * a.curvature[p][v]);
    }
}

TEST_P(Metrics, AnEmptyDomainHasNoValue) {
  WarpedPair pair = pairs()[0];
  std::fill(pair.in_domain.begin(), pair.in_domain.end(), 0);
  EXPECT_EQ(value(pair), 0.);
}

// The farther off, the less alike.
TEST_P(MultimodalMetrics, InvertedContrastIsMostAlikeWhereAligned) {
  double last = 0.;
  for (const double shift : {0., 1., 2., 4.}) {
    for (const double sign : {-1., 1.}) {
      const Point<3> by(sign * shift, 0.5 * sign * shift, 0.);
      const double dissimilarity =
          value(warped_pair([&](const Point<3>& x) { return blobs(x + by); }, inverted, 0.02));
      EXPECT_GT(dissimilarity, shift > 0. ? 1.02 * last : 0.) << shift;
      if (sign > 0.)
        last = dissimilarity;
    }
  }
}

TEST(Metric, LocalCorrelationDoesNotSeeABiasField) {
  const auto bias = [](const Point<3>& x) {
    return std::exp(0.3 * std::sin(0.03 * (x[0] + x[2])));
  };
  const auto value = [](const Intensity& other) {
    VoxelDerivatives derivatives;
    return similarity::LocalCorrelation().evaluate(warped_pair(blobs, other, 0.02), derivatives);
  };
  const auto biased = [&](const Point<3>& x) { return bias(x) * inverted(x); };
  const auto shifted = [](const Point<3>& x) { return inverted(x + Point<3>(2., 0., 0.)); };
  // A shift of one voxel counts ten times as much as the bias field.
  const double same = value(inverted);
  EXPECT_LT(10. * (value(biased) - same), value(shifted) - same);
}

TEST(Metric, SsdValueAndDerivative) {
  WarpedPair pair;
  pair.grid.size = {2, 1, 1};
  pair.grid.spacing = dealii::Tensor<1, 3>({2., 2., 2.});
  pair.values = {std::vector<float>{0.5f, 1.f}, std::vector<float>{0.25f, 0.f}};
  pair.in_domain = {1, 0};
  VoxelDerivatives derivatives;
  EXPECT_NEAR(similarity::SumOfSquaredDifferences().evaluate(pair, derivatives), 0.5 * 8. * 0.0625,
              1e-9);
  EXPECT_FLOAT_EQ(derivatives.slope.prone[0], 2.f);
  EXPECT_FLOAT_EQ(derivatives.slope.supine[0], -2.f);
  EXPECT_FLOAT_EQ(derivatives.slope.prone[1], 0.f);
}

TEST(Metric, ParametersThatCannotBe) {
  using similarity::LocalCorrelation;
  expect_error([] { similarity::NormalisedMutualInformation(4); }, {"4 bins", "8 to 256"});
  expect_error([] { LocalCorrelation(0., 0.05); }, {"0 mm", "Similarity/lncc/Window radius"});
  expect_error([] { LocalCorrelation(9., 0.); }, {"noise", "positive", "Similarity/lncc/Noise"});
}

} // namespace
} // namespace prosup::tests
