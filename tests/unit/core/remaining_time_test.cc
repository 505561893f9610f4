#include "prosup/core/remaining_time.h"

#include <gtest/gtest.h>

#include <limits>

namespace prosup::tests {
namespace {

std::string words_for(double seconds) {
  Countdown countdown;
  countdown.expect(seconds, 0.);
  return countdown.in_words(0.);
}

TEST(Countdown, IsAsCoarseAsEstimatesAre) {
  EXPECT_EQ(words_for(7.), ", about 10 s left");
  EXPECT_EQ(words_for(42.), ", about 40 s left");
  EXPECT_EQ(words_for(58.), ", about 1 min left");
  EXPECT_EQ(words_for(200.), ", about 3 min left");
  EXPECT_EQ(words_for(22. * 60.), ", about 20 min left");
  EXPECT_EQ(words_for(100. * 60.), ", about 2 h left");
}

TEST(Countdown, SaysNothingThatItDoesNotKnow) {
  EXPECT_EQ(Countdown().in_words(5.), "");
  EXPECT_EQ(words_for(3.), "") << "not worth a word";
  EXPECT_EQ(words_for(std::numeric_limits<double>::quiet_NaN()), "");
  EXPECT_EQ(words_for(std::numeric_limits<double>::infinity()), "");
  Countdown countdown;
  countdown.expect(60., 0.);
  EXPECT_EQ(countdown.in_words(100.), "") << "it took longer than expected";
  countdown.expect(60., 0.);
  countdown.forget();
  EXPECT_EQ(countdown.in_words(0.), "");
}

TEST(Countdown, FollowsTheClockAndNotTheNoiseOfEstimates) {
  Countdown countdown;
  countdown.expect(100., 0.);
  double noise = 1.;
  for (double now = 1.; now < 60.; now += 1., noise = -noise) {
    const std::string before = countdown.in_words(now);
    countdown.expect((100. - now) * (1. + 0.2 * noise), now);
    EXPECT_EQ(countdown.in_words(now), before) << now;
  }
  EXPECT_EQ(countdown.in_words(60.), ", about 40 s left");
  countdown.expect(200., 60.);
  EXPECT_EQ(countdown.in_words(60.), ", about 3 min left") << "what is far off counts";
}

} // namespace
} // namespace prosup::tests
