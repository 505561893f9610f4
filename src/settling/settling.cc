#include "prosup/settling/settling.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "decay_forecast.h"
#include "prosup/core/remaining_time.h"

namespace prosup::settling {

namespace {

constexpr unsigned corrections_per_snapshot = 10;

} // namespace

Settling::Settling(Simulation& simulation, const SettlingParameters& parameters,
                   Description description, const Log& log)
    : simulation_(simulation), parameters_(parameters), description_(std::move(description)),
      log_(log), caution_{parameters.lag_factor, parameters.step_safety, parameters.gravity_ramp,
                          description_.update_interval, 1.},
      caution_at_begin_(caution_), max_retries_(parameters.max_retries) {}

SettlingResult Settling::run(const Effort& effort) {
  const unsigned limit = parameters_.max_steps;
  gives_up_early_ = effort.gives_up_early;
  return simulate(effort.max_steps == 0 ? limit : std::min(effort.max_steps, limit), true);
}

SettlingResult Settling::advance(unsigned n_steps) {
  gives_up_early_ = false;
  return simulate(n_steps, false);
}

std::map<std::string, double> Settling::memory() const {
  return {{"lag_factor", caution_.lag_factor},     {"step_safety", caution_.step_safety},
          {"gravity_ramp", caution_.gravity_ramp}, {"update_interval", caution_.update_interval},
          {"tolerance", caution_.tolerance},       {"has_settled", has_settled_ ? 1. : 0.}};
}

void Settling::set_memory(const std::map<std::string, double>& memory) {
  caution_ = {memory.at("lag_factor"), memory.at("step_safety"), memory.at("gravity_ramp"),
              static_cast<unsigned>(memory.at("update_interval")), memory.at("tolerance")};
  has_settled_ = memory.at("has_settled") > 0.;
}

void Settling::begin() {
  first_ = last_good_ = simulation_.take_snapshot();
  caution_at_begin_ = caution_;
  last_good_error_ = std::numeric_limits<double>::max();
  has_kept_ = false;
  stall_watch_.restart();
}

SettlingResult Settling::simulate(unsigned max_steps, bool until_settled) {
  SettlingResult result;
  RemainingTime remaining;
  DecayForecast forecast;
  begin();
  unsigned n_corrections = 0;
  while (result.n_steps < max_steps) {
    const unsigned n = std::min(parameters_.correction_interval, max_steps - result.n_steps);
    const double duration = n * simulation_.time_step();
    const Report report = simulation_.advance(n, caution_.gravity_ramp);
    is_fully_loaded_ = report.is_fully_loaded;
    result.n_steps += n;
    if (const std::string what = trouble_in(report); !what.empty()) {
      retreat(what, Trouble::divergence, result);
      forecast.restart();
      remaining.expect({});
      continue;
    }
    const double error = judge(report, result);
    if (until_settled && is_fully_loaded_) {
      forecast.add(error / caution_.tolerance, remaining.elapsed());
      remaining.expect(forecast.seconds_left());
    }
    if ((result.converged && until_settled) ||
        (observer_ && !is_searching_ && !observer_(result.n_steps)))
      break;
    if (until_settled && is_fully_loaded_ &&
        stall_watch_.has_stalled(error, duration * simulation_.damping_rate(), caution_.lag_factor,
                                 result.n_steps)) {
      if (!recover_from_stall(error, result))
        break;
      forecast.restart();
      remaining.expect({});
      continue;
    }
    // Only the best state under the full load is kept: others may be about to diverge.
    if (++n_corrections % corrections_per_snapshot == 0 && is_fully_loaded_ &&
        error < last_good_error_) {
      last_good_ = simulation_.take_snapshot();
      last_good_error_ = error;
      has_kept_ = true;
    }
    correct();
    if (n_corrections % caution_.update_interval == 0)
      simulation_.update_time_step(caution_.step_safety);
    // A new call counts corrections from 0 again, which has to be the same for what is done at some
    // of them.
    if (keeper_ && until_settled && !is_searching_ && result.n_retries == 0 &&
        n_corrections % std::lcm(caution_.update_interval, corrections_per_snapshot) == 0)
      keeper_(result.n_steps);
  }
  if (until_settled && !result.converged && result.explanation.empty())
    end_unsettled(result);
  return result;
}

std::string Settling::trouble_in(const Report& report) const {
  if (report.has_inverted_reference)
    return description_.element + " of the unloaded configuration is inverted";
  if (!(report.min_jacobian > smallest_healthy_jacobian))
    return description_.element + " collapsed";
  if (!std::isfinite(report.residual) || !std::isfinite(report.kinetic_energy))
    return "forces are not finite";
  if (report.kinetic_energy > 1.)
    return "the body moves faster than in a free fall";
  return {};
}

/// Fills the result; returns the error over its tolerance.
double Settling::judge(const Report& report, SettlingResult& result) {
  result.min_jacobian = report.min_jacobian;
  result.residual = report.residual;
  result.distance = report.distance;
  log_.progress(format("  %s: step %u, %s, min J %.2f", description_.name.c_str(), result.n_steps,
                       state_text(result).c_str(), result.min_jacobian));
  const double error = std::max(result.residual / parameters_.residual_tolerance,
                                result.distance / parameters_.position_tolerance);
  // The forces that are left may still move the body by about the last of these.
  result.converged = error < caution_.tolerance && is_fully_loaded_ &&
                     result.residual * simulation_.largest_displacement() <
                         caution_.tolerance * parameters_.position_tolerance;
  has_settled_ = has_settled_ || result.converged;
  return error;
}

void Settling::correct() {
  if (simulation_.holds_reference())
    return;
  const double lag = caution_.lag_factor / simulation_.damping_rate();
  simulation_.correct(
      parameters_.correction_scheme() == CorrectionScheme::full
          ? 1.
          : std::min(1., parameters_.correction_interval * simulation_.time_step() / lag));
}

std::string Settling::state_text(const SettlingResult& result) const {
  return format("residual %.1e, %s %.3f mm", result.residual, description_.distance.c_str(),
                result.distance);
}

} // namespace prosup::settling
