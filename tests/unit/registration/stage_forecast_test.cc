#include "registration/stage_forecast.h"

#include <gtest/gtest.h>

#include <cmath>
#include <tuple>
#include <vector>

namespace prosup::tests {
namespace {

using registration::StageForecast;
using registration::StepForecast;

constexpr double least_gain = 0.02, decline = 0.3;

/// Steps that a level takes whose gains fall by `decline` until one is below least_gain of all.
unsigned steps_of_level() {
  unsigned n = 1;
  for (double gain = 1., all = 1.; gain >= least_gain * all; ++n)
    all += gain *= decline;
  return n;
}

TEST(StepForecast, SaysNothingBeforeTwoSteps) {
  StepForecast forecast({1., 1.}, least_gain);
  EXPECT_FALSE(forecast.seconds_left().has_value());
  forecast.begin(0, 10., 0.);
  forecast.step(5., 1.);
  EXPECT_FALSE(forecast.seconds_left().has_value());
  forecast.step(4., 2.);
  EXPECT_TRUE(forecast.seconds_left().has_value());
}

TEST(StepForecast, FindsTheEndOfALevelWithGeometricGains) {
  StepForecast forecast({1.}, least_gain);
  double value = 100., gain = 40., now = 0.;
  forecast.begin(0, value, now);
  const unsigned n = steps_of_level();
  for (unsigned i = 1; i <= n; ++i, gain *= decline) {
    forecast.step(value -= gain, now += 3.);
    if (const auto left = forecast.seconds_left()) {
      EXPECT_GE(*left, 3.) << "there may always be another one";
      EXPECT_NEAR(*left, 3. * (n - i), 6.) << i;
    }
  }
}

TEST(StepForecast, CountsFinerLevelsByTheirCost) {
  StepForecast forecast({1., 4., 16.}, least_gain);
  forecast.begin(0, 10., 0.);
  forecast.step(5., 1.);
  forecast.step(4.99, 2.); // gains nothing: the level is at its end
  EXPECT_NEAR(*forecast.seconds_left(), 1. + 5. * 4. + 5. * 16., 1e-9);
  forecast.begin(1, 20., 2.5);
  EXPECT_NEAR(*forecast.seconds_left(), 5. * 4. + 5. * 16., 1e-9);
  forecast.step(10., 8.5); // 6 s instead of 4
  EXPECT_NEAR(*forecast.seconds_left(), 4. * 6. + 5. * 24., 1e-9);
}

TEST(StepForecast, SurvivesSteps) {
  // A stage that goes on from a checkpoint, values that rise, no gain at all.
  StepForecast forecast({1., 2.}, least_gain);
  forecast.begin(1, 10., 0.);
  for (const double value : {10., 12., 12., 12., 5.}) {
    forecast.step(value, 1.);
    if (const auto left = forecast.seconds_left()) {
      EXPECT_TRUE(std::isfinite(*left) && *left >= 0.) << value;
    }
  }
}

TEST(StageForecast, PassesOnWhatItSeesAndTellsTheTime) {
  std::vector<double> seen;
  const registration::Observer observer = [&](const registration::SimilarityRecord& record) {
    seen.push_back(record.value);
  };
  {
    StageForecast forecast({8., 4.}, {{1., 1.}, least_gain}, observer);
    const registration::Observer told = forecast.observer();
    for (const auto& [level, iteration, value] :
         std::vector<std::tuple<double, unsigned, double>>{{8., 3, 9.}, {8., 4, 7.}, {4., 0, 5.}})
      told({"material", level, iteration, 0., value});
  }
  EXPECT_EQ(seen, (std::vector<double>{9., 7., 5.}));
  const registration::Observer nobody;
  StageForecast alone({8.}, {{1.}, least_gain}, nobody);
  alone.observer()({"material", 8., 0, 0., 1.});
}

} // namespace
} // namespace prosup::tests
