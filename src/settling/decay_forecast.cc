#include "decay_forecast.h"

#include <cmath>

namespace prosup::settling {

namespace {

// Before that, what looks like a decay may be one swing.
constexpr double least_fall = 3.;
constexpr unsigned least_blocks = 5;

} // namespace

void DecayForecast::add(double error, double now) {
  error_ = error;
  time_ = now;
  ++n_since_peak_;
  if (!(error < peak_)) {
    peak_ = error;
    peak_time_ = now;
    n_since_peak_ = 0;
  }
}

std::optional<double> DecayForecast::seconds_left() const {
  if (n_since_peak_ < least_blocks || !(error_ > 0.) || !(peak_ > least_fall * error_))
    return {};
  const double to_fall = std::log(error_);
  return to_fall > 0. ? (time_ - peak_time_) * to_fall / std::log(peak_ / error_) : 0.;
}

} // namespace prosup::settling
