#include "prosup/settling/settling.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "oscillator.h"
#include "prosup/core/error.h"

namespace prosup::tests {
namespace {

using namespace settling;

struct Parameters : SettlingParameters {
  Parameters() : SettlingParameters(0.5) {}
};

class OscillatorSettles : public ::testing::Test {
protected:
  OscillatorSettles() { oscillator.safety = parameters.step_safety; }

  Settling make() { return {oscillator, parameters, description}; }

  /// The message of the error that run() throws; empty if it throws none.
  std::string error_of_run() {
    try {
      make().run();
    } catch (const DivergenceError& error) {
      return error.what();
    }
    return "";
  }

  Parameters parameters;
  Oscillator oscillator;
  const Description description{"the mass", "Toy", "a spring", "max |x-u-X|", 20};
};

void expect_words(const std::string& text, const std::vector<std::string>& all_words) {
  for (const std::string& words : all_words)
    EXPECT_NE(text.find(words), std::string::npos) << words << " is not in: " << text;
}

TEST_F(OscillatorSettles, InTheUnloadedPosition) {
  const SettlingResult result = make().run();
  EXPECT_TRUE(result.converged) << result.explanation;
  EXPECT_EQ(result.n_retries, 0u);
  EXPECT_EQ(result.explanation, "");
  EXPECT_EQ(result.n_steps, oscillator.n_steps);
  EXPECT_LT(result.residual, parameters.residual_tolerance);
  EXPECT_LT(result.distance, parameters.position_tolerance);
  EXPECT_NEAR(oscillator.unloaded, Oscillator::exact(), 2. * parameters.position_tolerance);
}

TEST_F(OscillatorSettles, CorrectedByThePartOfTheLag) {
  parameters.lag_factor = 20.;
  make().run();
  const double h = oscillator.time_step();
  EXPECT_NEAR(oscillator.last_part,
              parameters.correction_interval * h * oscillator.damping_rate() / 20., 1e-12);
  parameters.correction = "full";
  make().advance(20);
  EXPECT_EQ(oscillator.last_part, 1.);
}

TEST_F(OscillatorSettles, WithoutCorrectionsWhereTheReferenceIsHeld) {
  oscillator.is_held = true;
  EXPECT_TRUE(make().run().converged);
  EXPECT_EQ(oscillator.unloaded, Oscillator::x);
  EXPECT_NEAR(oscillator.displacement, Oscillator::g / Oscillator::k, 0.01);
}

TEST_F(OscillatorSettles, AfterItHasGoneBackFromDivergence) {
  // States are kept every 100 steps.
  for (const unsigned collapse_after : {50u, 150u}) {
    oscillator = Oscillator();
    oscillator.safety = parameters.step_safety;
    oscillator.largest_safety = 0.45;
    oscillator.collapse_after = collapse_after;
    Settling settling = make();
    const SettlingResult result = settling.run();
    EXPECT_TRUE(result.converged) << result.explanation;
    EXPECT_EQ(result.n_retries, 1u);
    EXPECT_EQ(oscillator.n_restored, 1u);
    if (collapse_after < 100)
      EXPECT_EQ(oscillator.restored, Oscillator::x);
    else
      EXPECT_LT(oscillator.restored, Oscillator::x - 0.5);
    EXPECT_EQ(oscillator.strength, 1u);
    EXPECT_DOUBLE_EQ(oscillator.safety, 0.8 * parameters.step_safety);
    EXPECT_DOUBLE_EQ(settling.caution().lag_factor, 2. * parameters.lag_factor);
    EXPECT_GE(settling.caution().gravity_ramp, 4. * settling.caution().lag_factor);
    EXPECT_LT(settling.caution().tolerance, 1.);
    EXPECT_LT(settling.caution().update_interval, description.update_interval);
    EXPECT_NEAR(oscillator.unloaded, Oscillator::exact(), parameters.position_tolerance);
  }
}

TEST_F(OscillatorSettles, FromTheStartIfItDivergesAgainFromTheKeptState) {
  oscillator.largest_safety = 0.39; // met after two retries: 0.5, 0.4, 0.32
  oscillator.collapse_after = 150;
  const SettlingResult result = make().run();
  EXPECT_TRUE(result.converged) << result.explanation;
  EXPECT_EQ(result.n_retries, 2u);
  EXPECT_EQ(oscillator.restored, Oscillator::x);
}

TEST_F(OscillatorSettles, OrIsLeftInTheLastGoodState) {
  oscillator.largest_safety = 0.1;
  oscillator.collapse_after = 150;
  parameters.max_retries = 0;
  EXPECT_NE(error_of_run(), "");
  EXPECT_LT(oscillator.unloaded, Oscillator::x - 0.5);
  EXPECT_GT(oscillator.unloaded, Oscillator::exact() + parameters.position_tolerance);
}

TEST_F(OscillatorSettles, OrGivesUpEarlyWithoutAChangeOfTheBodyAndSettlesWithPatience) {
  oscillator.largest_safety = 0.45; // met after one retry
  Settling settling = make();
  try {
    settling.run({0, true});
    FAIL() << "a return was made";
  } catch (const DivergenceError& error) {
    EXPECT_EQ(std::string(error.what()).find("retries"), std::string::npos) << error.what();
    EXPECT_EQ(std::string(error.what()).find("weight"), std::string::npos) << error.what();
  }
  EXPECT_EQ(oscillator.n_mended, 0u);
  EXPECT_EQ(oscillator.strength, 0u);
  EXPECT_EQ(oscillator.unloaded, Oscillator::x);
  EXPECT_EQ(settling.caution().step_safety, parameters.step_safety);
  const SettlingResult result = settling.run();
  EXPECT_TRUE(result.converged) << result.explanation;
  EXPECT_EQ(result.n_retries, 1u);
}

TEST_F(OscillatorSettles, WithTheSameLagIfItMendedItself) {
  oscillator.largest_safety = 0.45;
  oscillator.mends_itself = true;
  Settling settling = make();
  const SettlingResult result = settling.run();
  EXPECT_TRUE(result.converged) << result.explanation;
  EXPECT_EQ(oscillator.n_mended, 1u);
  EXPECT_EQ(oscillator.strength, 0u);
  EXPECT_EQ(settling.caution().lag_factor, parameters.lag_factor);
  EXPECT_EQ(settling.caution().tolerance, 1.);
  EXPECT_LT(settling.caution().step_safety, parameters.step_safety);
}

TEST_F(OscillatorSettles, AfterAStallWithMoreDampingAndTheSameStep) {
  oscillator.strength_that_rests = 2;
  Settling settling = make();
  const SettlingResult result = settling.run();
  EXPECT_TRUE(result.converged) << result.explanation;
  EXPECT_EQ(result.n_retries, 2u);
  EXPECT_EQ(oscillator.strength, 2u);
  EXPECT_EQ(settling.caution().step_safety, parameters.step_safety);
  EXPECT_DOUBLE_EQ(settling.caution().lag_factor, 4. * parameters.lag_factor);
  EXPECT_NEAR(oscillator.unloaded, Oscillator::exact(), 2. * parameters.position_tolerance);
}

TEST_F(OscillatorSettles, OrSaysForWhichPartOfTheWeightItDoes) {
  oscillator.largest_load = 0.6;
  parameters.max_retries = 2;
  const std::string message = error_of_run();
  expect_words(message, {"The unloading of the mass diverged at step", "a spring collapsed, cell 7",
                         "soft as butter", "2 retries", "up to 0.59", "not found for 0.62"});
  EXPECT_EQ(oscillator.unloaded, Oscillator::x); // no state was good
}

TEST_F(OscillatorSettles, OrSaysThatItDoesForNoPart) {
  oscillator.largest_load = 0.001;
  parameters.max_retries = 1;
  expect_words(error_of_run(), {"not even found for 0.03 of the weight"});
}

TEST_F(OscillatorSettles, AndIsNotSearchedOnceItHasSettled) {
  Settling settling = make();
  ASSERT_TRUE(settling.run().converged);
  oscillator.largest_load = 0.6;
  try {
    settling.run();
    FAIL() << "It collapses.";
  } catch (const DivergenceError& error) {
    expect_words(error.what(), {"raise 'Material/Shear modulus'"});
    EXPECT_EQ(std::string(error.what()).find("exists up to"), std::string::npos);
  }
  // What did not help is forgotten, so that the next trial begins as this one.
  EXPECT_EQ(settling.caution().lag_factor, parameters.lag_factor);
  oscillator.largest_load = 1e9;
  EXPECT_TRUE(settling.run().converged);
}

TEST_F(OscillatorSettles, OrForgetsTheCarefulValuesOfTheSearch) {
  oscillator.largest_load = 0.6;
  Settling settling = make();
  EXPECT_THROW(settling.run(), DivergenceError);
  EXPECT_EQ(settling.caution().lag_factor, parameters.lag_factor);
  EXPECT_EQ(settling.caution().step_safety, parameters.step_safety);
}

TEST_F(OscillatorSettles, OrSaysThatTheStepsWereTooFew) {
  const SettlingResult rising = make().run(10);
  EXPECT_FALSE(rising.converged);
  EXPECT_EQ(rising.n_steps, 10u);
  expect_words(rising.explanation, {"did not settle in 10 steps with 0 retries", "still rising"});
  parameters.position_tolerance = 1e-9;
  parameters.residual_tolerance = 1e-12;
  parameters.max_steps = 50;
  const SettlingResult loaded = make().run(1000);
  EXPECT_EQ(loaded.n_steps, 50u);
  expect_words(loaded.explanation, {"'Toy/Maximum steps' or its tolerances"});
}

TEST_F(OscillatorSettles, OrDivergesIfItSwingsInTheEnd) {
  oscillator.strength_that_rests = 100;
  parameters.max_retries = 3;
  expect_words(error_of_run(), {"it neither settles nor diverges", "3 retries"});
}

TEST_F(OscillatorSettles, UnlessTheObserverStopsIt) {
  Settling settling = make();
  unsigned last = 0;
  settling.set_observer([&](unsigned n_steps) {
    last = n_steps;
    return n_steps < 30;
  });
  EXPECT_EQ(settling.run().n_steps, 30u);
  EXPECT_EQ(last, 30u);
}

TEST_F(OscillatorSettles, AdvancingOnlyTakesItsSteps) {
  const SettlingResult result = make().advance(205);
  EXPECT_EQ(result.n_steps, 205u);
  EXPECT_EQ(oscillator.n_steps, 205u);
  EXPECT_FALSE(result.converged);
  EXPECT_EQ(result.explanation, "");
}

TEST(StallWatch, SeesAnErrorThatFallsTooLittle) {
  for (const double fall_per_window : {0.5, 0.9}) {
    StallWatch watch;
    bool stalled = false;
    double error = 1.;
    for (unsigned n = 10; n <= 2000; n += 10) {
      error *= std::pow(fall_per_window, 10. / 300.);
      stalled = stalled || watch.has_stalled(error, 1., 1., n);
    }
    EXPECT_EQ(stalled, fall_per_window > 0.8) << fall_per_window;
  }
}

TEST(StallWatch, WaitsForTheLag) {
  StallWatch watch;
  for (unsigned n = 10; n <= 4000; n += 10)
    EXPECT_FALSE(watch.has_stalled(1., 0.1, 5., n)) << n; // 40 of 50 damping times
}

} // namespace
} // namespace prosup::tests
