// The search for the part of gravity under which a body settles, to tell the user.

#include <algorithm>

#include "prosup/core/error.h"
#include "prosup/settling/settling.h"

namespace prosup::settling {

namespace {

// Bisection, to 1/32 of gravity.
constexpr unsigned n_tries = 5, steps_per_try = 6000;

} // namespace

/// A caller that has seen the body settle tries other things, and only has to know
/// that they fail: it is not searched.
std::string Settling::search_load() {
  if (has_settled_ || is_searching_ || !simulation_.has_gravity())
    return "; " + simulation_.advice();
  log_.line("  " + description_.name +
            ": looking for the part of its weight under which it settles");
  const Snapshot last_good = last_good_;
  const Caution caution_at_begin = caution_at_begin_;
  Snapshot settled_state = first_;
  double settled = 0., failed = 1.;
  is_searching_ = true;
  for (unsigned i = 0; i < n_tries; ++i) {
    const double middle = 0.5 * (settled + failed);
    simulation_.restore(settled_state);
    simulation_.load_between(settled, middle);
    be_careful();
    simulation_.update_time_step(caution_.step_safety);
    if (settles()) {
      settled = middle;
      settled_state = simulation_.take_snapshot();
    } else
      failed = middle;
  }
  is_searching_ = false;
  has_settled_ = false;
  max_retries_ = parameters_.max_retries;
  caution_at_begin_ = caution_at_begin;
  simulation_.load_between(0., 1.);
  simulation_.restore(last_good);
  const char* const state = simulation_.holds_reference() ? "a loaded state" : "an unloaded state";
  if (settled == 0.)
    return format(
        "; %s was not even found for %.2f of the weight, so check the mask and mesh there, "
        "and 'Material'",
        state, failed);
  return format("; %s exists up to %.2f of the weight at least and was not found for %.2f; %s",
                state, settled, failed, simulation_.advice().c_str());
}

bool Settling::settles() {
  try {
    return simulate(std::min(steps_per_try, parameters_.max_steps), true).converged;
  } catch (const DivergenceError&) {
    return false;
  }
}

/// Values that are safe from the start, with few retries.
void Settling::be_careful() {
  const double lag = 4. * std::max(1., parameters_.lag_factor);
  caution_ = {lag, 0.8 * std::min(1., parameters_.step_safety), 2. * lag,
              description_.update_interval / 4, 1.};
  max_retries_ = std::min(3u, parameters_.max_retries);
}

} // namespace prosup::settling
