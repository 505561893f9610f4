#include "stage_forecast.h"

#include <algorithm>
#include <cmath>

namespace prosup::registration {

namespace {

// Levels took two to eight steps in the registrations that were looked at (docs/files.md).
constexpr double usual_steps = 5., most_steps = 8.;

constexpr unsigned least_steps = 2; // before anything is said

} // namespace

void StepForecast::begin(std::size_t level, double value, double now) {
  level_ = level;
  n_steps_ = 0;
  first_ = last_ = value;
  now_ = now;
}

void StepForecast::step(double value, double now) {
  const unsigned n = level_ == measured_level_ ? n_steps_ : 0;
  step_time_ = (n * step_time_ + now - now_) / (n + 1);
  measured_level_ = level_;
  ++n_steps_;
  ++n_all_;
  last_gain_ = last_ - value;
  last_ = value;
  now_ = now;
}

/// On the present level.
double StepForecast::steps_left() const {
  const double part = last_gain_ / (first_ - last_); // of all gains
  if (n_steps_ < 2 || !(part < 1.))
    return std::max(usual_steps - n_steps_, 1.);
  if (!(part > least_gain_))
    return 1.;
  const double decline = std::pow(part, 1. / (n_steps_ - 1));
  return std::min(1. + std::log(least_gain_ / part) / std::log(decline), most_steps);
}

std::optional<double> StepForecast::seconds_left() const {
  if (n_all_ < least_steps)
    return {};
  double cost = steps_left() * costs_[level_];
  for (std::size_t level = level_ + 1; level < costs_.size(); ++level)
    cost += usual_steps * costs_[level];
  return step_time_ * cost / costs_[measured_level_];
}

Observer StageForecast::observer() {
  return [this](const SimilarityRecord& record) { see(record); };
}

void StageForecast::see(const SimilarityRecord& record) {
  const auto level = std::find(levels_.begin(), levels_.end(), record.level);
  // A stage that goes on from a checkpoint begins within a level.
  if (record.iteration == 0 || record.level != level_)
    forecast_.begin(static_cast<std::size_t>(level - levels_.begin()), record.value,
                    remaining_.elapsed());
  else
    forecast_.step(record.value, remaining_.elapsed());
  level_ = record.level;
  remaining_.expect(forecast_.seconds_left());
  if (observer_)
    observer_(record);
}

} // namespace prosup::registration
