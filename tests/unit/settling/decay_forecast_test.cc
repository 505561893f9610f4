#include "settling/decay_forecast.h"

#include <gtest/gtest.h>

#include <cmath>

namespace prosup::tests {
namespace {

using settling::DecayForecast;

constexpr double peak = 100., decay_time = 10.;

/// A decay that is 1 at decay_time log(peak), and less by up to 2 `swing` of it where it swings.
double error_at(double time, double swing) {
  return peak * std::exp(-time / decay_time) * (1. - swing + swing * std::cos(time));
}

TEST(DecayForecast, FindsTheEndOfADecay) {
  DecayForecast forecast;
  const double end = decay_time * std::log(peak);
  unsigned n_told = 0;
  for (double time = 0.; time < end; time += 0.5) {
    forecast.add(error_at(time, 0.), time);
    if (const auto left = forecast.seconds_left()) {
      EXPECT_NEAR(*left, end - time, 1e-9);
      ++n_told;
    }
  }
  EXPECT_GT(n_told, 60u);
}

TEST(DecayForecast, IsRightToAFactorOfTwoForADecayThatSwings) {
  DecayForecast forecast;
  const double end = decay_time * std::log(peak);
  for (double time = 0.; time < 0.8 * end; time += 0.5) {
    forecast.add(error_at(time, 0.1), time); // a fifth is 0.22 of the logarithm, of 0.92 at the end
    if (const auto left = forecast.seconds_left()) {
      EXPECT_GT(*left, 0.5 * (end - time)) << time;
      EXPECT_LT(*left, 2. * (end - time)) << time;
    }
  }
}

TEST(DecayForecast, HasNoBasisWhereNothingDecays) {
  DecayForecast forecast;
  for (unsigned i = 0; i < 100; ++i) {
    forecast.add(50. + 20. * std::cos(0.3 * i), i);
    EXPECT_FALSE(forecast.seconds_left().has_value()) << i;
  }
  for (unsigned i = 0; i < 40; ++i)
    forecast.add(peak * std::exp(-0.1 * i), 100. + i);
  EXPECT_TRUE(forecast.seconds_left().has_value());
  forecast.restart();
  EXPECT_FALSE(forecast.seconds_left().has_value()) << "after a return nothing is known";
}

} // namespace
} // namespace prosup::tests
