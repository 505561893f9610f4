#include "prosup/similarity/metric.h"

#include <gtest/gtest.h>

#include <numeric>

#include "expect_error.h"
#include "warped_pairs.h"

namespace prosup::tests {
namespace {

using similarity::make_metric;

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

class Metrics : public ::testing::TestWithParam<const char*> {
protected:
  double value(const WarpedPair& pair) const {
    VoxelDerivatives derivatives;
    return metric->evaluate(pair, derivatives);
  }
  const std::unique_ptr<similarity::Metric> metric = make_metric(GetParam());
};

class MultimodalMetrics : public Metrics {};

INSTANTIATE_TEST_SUITE_P(All, Metrics, ::testing::Values("ssd", "nmi", "lncc"),
                         [](const auto& info) { return std::string(info.param); });
INSTANTIATE_TEST_SUITE_P(All, MultimodalMetrics, ::testing::Values("nmi", "lncc"),
                         [](const auto& info) { return std::string(info.param); });

TEST_P(Metrics, SlopeIsTheDerivativeOfTheValue) {
  const double step = 1e-3;
  for (const WarpedPair& pair : pairs()) {
    VoxelDerivatives derivatives;
    metric->evaluate(pair, derivatives);
    // Along the slope itself, and along noise that makes it bigger at no voxel.
    for (unsigned s = 0; s < 2; ++s) {
      std::vector<float> direction = random_direction(pair.in_domain.size());
      const double size = std::sqrt(inner(derivatives.slope[s], derivatives.slope[s]));
      for (std::size_t v = 0; v < direction.size(); ++v)
        direction[v] += static_cast<float>(50. / size) * derivatives.slope[s][v];
      const double slope =
          (value(moved(pair, s, direction, step)) - value(moved(pair, s, direction, -step))) /
          (2. * step);
      EXPECT_NEAR(inner(derivatives.slope[s], direction), slope, 3e-3 * std::abs(slope));
      EXPECT_GT(std::abs(slope), 1.);
    }
  }
}

TEST_P(Metrics, SlopeOfSingleVoxels) {
  const WarpedPair pair = pairs()[1];
  VoxelDerivatives derivatives;
  metric->evaluate(pair, derivatives);
  const double step = 0.01;
  for (unsigned s = 0; s < 2; ++s)
    for (const std::size_t v : {3000u, 6130u, 7001u}) {
      std::vector<float> direction(pair.in_domain.size(), 0.f);
      direction[v] = 1.f;
      const double slope =
          (value(moved(pair, s, direction, step)) - value(moved(pair, s, direction, -step))) /
          (2. * step);
      EXPECT_NEAR(derivatives.slope[s][v], slope, 0.02 * std::abs(slope) + 1e-3) << "voxel " << v;
    }
}

// In directions that are noise, the second derivative of the value is the sum of
// the curvatures: exactly for the ssd, which is quadratic, and to a factor of two
// for the others, of which the curvature is an expectation.
TEST_P(Metrics, CurvatureIsTheSecondDerivativeWhereTheImagesMatch) {
  const WarpedPair pair = GetParam() == std::string("ssd") ? warped_pair(blobs, blobs, 0.05)
                                                           : warped_pair(blobs, inverted, 0.05);
  VoxelDerivatives derivatives;
  metric->evaluate(pair, derivatives);
  const std::vector<float> direction = random_direction(pair.in_domain.size());
  const double step = 0.01;
  for (unsigned s = 0; s < 2; ++s) {
    double expected = 0.;
    for (std::size_t v = 0; v < direction.size(); ++v)
      expected += derivatives.curvature[s][v] * direction[v] * direction[v];
    const double second = (value(moved(pair, s, direction, step)) - 2. * value(pair) +
                           value(moved(pair, s, direction, -step))) /
                          (step * step);
    EXPECT_GT(expected, 0.5 * second);
    EXPECT_LT(expected, 2. * second);
  }
}

TEST_P(Metrics, NothingOutsideTheDomainAndNoNegativeCurvature) {
  for (const WarpedPair& pair : pairs()) {
    VoxelDerivatives derivatives;
    metric->evaluate(pair, derivatives);
    for (unsigned s = 0; s < 2; ++s)
      for (std::size_t v = 0; v < pair.in_domain.size(); ++v) {
        ASSERT_TRUE(std::isfinite(derivatives.slope[s][v]));
        ASSERT_TRUE(std::isfinite(derivatives.curvature[s][v]));
        ASSERT_GE(derivatives.curvature[s][v], 0.f);
        if (!pair.in_domain[v]) {
          ASSERT_EQ(derivatives.slope[s][v], 0.f);
          ASSERT_EQ(derivatives.curvature[s][v], 0.f);
        }
      }
  }
}

TEST_P(Metrics, SwappingTheImagesSwapsTheDerivatives) {
  const WarpedPair pair = pairs()[1];
  WarpedPair swapped = pair;
  std::swap(swapped.values[0], swapped.values[1]);
  VoxelDerivatives a, b;
  const double value = metric->evaluate(pair, a);
  EXPECT_NEAR(metric->evaluate(swapped, b), value, 1e-9 * value);
  for (unsigned s = 0; s < 2; ++s)
    for (std::size_t v = 0; v < pair.in_domain.size(); ++v) {
      ASSERT_NEAR(a.slope[s][v], b.slope[1 - s][v], 1e-5 * std::abs(a.slope[s][v]) + 1e-9);
      ASSERT_NEAR(a.curvature[s][v], b.curvature[1 - s][v], 1e-5 * a.curvature[s][v]);
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
  const auto value = [](const char* name, const Intensity& other) {
    VoxelDerivatives derivatives;
    return make_metric(name)->evaluate(warped_pair(blobs, other, 0.02), derivatives);
  };
  const auto biased = [&](const Point<3>& x) { return bias(x) * inverted(x); };
  const auto shifted = [](const Point<3>& x) { return inverted(x + Point<3>(2., 0., 0.)); };
  // A shift of one voxel counts ten times as much as the bias field.
  const double same = value("lncc", inverted);
  EXPECT_LT(10. * (value("lncc", biased) - same), value("lncc", shifted) - same);
}

TEST(Metric, SsdValueAndDerivative) {
  WarpedPair pair;
  pair.grid.size = {2, 1, 1};
  pair.grid.spacing = dealii::Tensor<1, 3>({2., 2., 2.});
  pair.values = {std::vector<float>{0.5f, 1.f}, std::vector<float>{0.25f, 0.f}};
  pair.in_domain = {1, 0};
  VoxelDerivatives derivatives;
  EXPECT_NEAR(make_metric("ssd")->evaluate(pair, derivatives), 0.5 * 8. * 0.0625, 1e-9);
  EXPECT_FLOAT_EQ(derivatives.slope[0][0], 2.f);
  EXPECT_FLOAT_EQ(derivatives.slope[1][0], -2.f);
  EXPECT_FLOAT_EQ(derivatives.slope[0][1], 0.f);
}

TEST(Metric, UnknownNameIsAnsweredWithTheList) {
  expect_error([] { make_metric("psnr"); }, {"psnr", "allowed are: ssd, nmi, lncc"});
}

TEST(Metric, ParametersThatCannotBe) {
  similarity::MetricParameters parameters;
  parameters.n_bins = 4;
  parameters.window_radius = 0.;
  expect_error([&] { make_metric("nmi", parameters); }, {"4 bins", "8 to 256"});
  expect_error([&] { make_metric("lncc", parameters); }, {"0 mm", "Window radius"});
  parameters.window_radius = 9.;
  parameters.noise = 0.;
  expect_error([&] { make_metric("lncc", parameters); }, {"noise", "positive"});
}

} // namespace
} // namespace prosup::tests
