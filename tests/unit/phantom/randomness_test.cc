#include <gtest/gtest.h>

#include <cmath>

#include "prosup/phantom/random.h"
#include "prosup/phantom/smooth_noise.h"

namespace prosup::tests {
namespace {

using namespace prosup::phantom;
using dealii::Point;

struct Moments {
  double mean, deviation;
};

template <class Draw>
Moments moments(unsigned n, Draw&& draw) {
  double sum = 0., squares = 0.;
  for (unsigned i = 0; i < n; ++i) {
    const double value = draw(i);
    sum += value;
    squares += value * value;
  }
  return {sum / n, std::sqrt(squares / n - sum * sum / n / n)};
}

TEST(Random, IsThatOfItsSeedAndStream) {
  Random a(7, Stream::noise), same(7, Stream::noise), other_seed(8, Stream::noise),
      other_part(7, Stream::noise, 1);
  const double value = a.normal();
  EXPECT_EQ(value, same.normal());
  EXPECT_NE(value, other_seed.normal());
  EXPECT_NE(value, other_part.normal());
}

TEST(Random, HasTheMomentsOfItsDistributions) {
  Random random(3, Stream::noise);
  const unsigned n = 200000; // standard error of a mean: 1/450
  const Moments uniform = moments(n, [&](unsigned) { return random.uniform(); });
  EXPECT_NEAR(uniform.mean, 0.5, 5e-3);
  EXPECT_NEAR(uniform.deviation, std::sqrt(1. / 12.), 5e-3);
  const Moments normal = moments(n, [&](unsigned) { return random.normal(); });
  EXPECT_NEAR(normal.mean, 0., 0.01);
  EXPECT_NEAR(normal.deviation, 1., 0.01);
}

// Gudbjartsson and Patz, Magn. Reson. Med. 34, 1995: Rayleigh without signal,
// nearly Gaussian about sqrt(A^2 + sigma^2) where there is much.
TEST(Random, RicianNoiseIsRayleighInAirAndGaussianInTissue) {
  Random random(4, Stream::noise);
  const unsigned n = 200000;
  const double sigma = 3.;
  const Moments air = moments(n, [&](unsigned) { return rician(0., sigma, random); });
  EXPECT_NEAR(air.mean, sigma * std::sqrt(M_PI / 2.), 0.02);
  EXPECT_NEAR(air.deviation, sigma * std::sqrt(2. - M_PI / 2.), 0.02);
  const Moments tissue = moments(n, [&](unsigned) { return rician(100., sigma, random); });
  EXPECT_NEAR(tissue.mean, std::sqrt(100. * 100. + sigma * sigma), 0.03);
  EXPECT_NEAR(tissue.deviation, sigma, 0.03);
}

TEST(SmoothNoise, HasMeanZeroAndDeviationOne) {
  const SmoothNoise noise(5., 11, Stream::fat_texture);
  Random random(1, Stream::landmarks);
  // 32^3 coefficients: the mean is known to some 1/180.
  const Moments values = moments(400000, [&](unsigned) {
    return noise({160. * random.uniform(), 160. * random.uniform(), 160. * random.uniform()});
  });
  EXPECT_NEAR(values.mean, 0., 0.05);
  EXPECT_NEAR(values.deviation, 1., 0.05);
}

TEST(SmoothNoise, IsSmoothAndPeriodic) {
  const SmoothNoise noise(5., 11, Stream::fat_texture);
  const Point<3> p(3., -14.999999, 77.);
  const Point<3> across_a_knot(3., -15.000001, 77.);
  EXPECT_NEAR(noise(p), noise(across_a_knot), 1e-5);
  EXPECT_NEAR(noise(p), noise({p[0] + 160., p[1] - 160., p[2]}), 1e-9);
  EXPECT_NE(noise(p), noise({p[0] + 5., p[1], p[2]}));
}

} // namespace
} // namespace prosup::tests
