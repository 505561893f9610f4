#include "prosup/settling/stall_watch.h"

#include <algorithm>
#include <limits>

namespace prosup::settling {

namespace {

constexpr double least_progress = 0.2;

// Slow modes of nearly incompressible tissue take a long window.
constexpr double window_in_lags = 10.;
constexpr unsigned window_in_steps = 300;

} // namespace

void StallWatch::start_window(double error, unsigned n_steps) {
  smallest_ = error;
  window_ = 0.;
  first_step_ = n_steps;
}

bool StallWatch::has_stalled(double error, double duration, double lag_factor, unsigned n_steps) {
  if (is_first_) {
    is_first_ = false;
    smallest_before_ = std::numeric_limits<double>::max();
    start_window(error, n_steps);
  }
  smallest_ = std::min(smallest_, error);
  window_ += duration;
  if (window_ < window_in_lags * std::max(1., lag_factor) ||
      n_steps < first_step_ + window_in_steps)
    return false;
  const bool result = smallest_ > (1. - least_progress) * smallest_before_;
  smallest_before_ = std::min(smallest_before_, smallest_);
  start_window(error, n_steps);
  return result;
}

} // namespace prosup::settling
