// What Settling does with a simulation that diverges or stalls.

#include <algorithm>
#include <limits>

#include "prosup/core/error.h"
#include "prosup/settling/settling.h"

namespace prosup::settling {

namespace {

constexpr double ramp_in_lags = 4.;

// A body that needed a retry has soft modes, in which a small residual means a
// larger error of position.
constexpr double tolerance_after_retreat = 0.25;

// An unsettled state whose error is below this many tolerances is still of use.
constexpr double usable = 10.;

} // namespace

/// The full correction stays full: whoever asks for the paper's scheme gets it.
bool Settling::is_full_correction() const {
  return !simulation_.holds_reference() &&
         parameters_.correction_scheme() == CorrectionScheme::full;
}

/// Returns whether the simulation may continue. @throws as run().
bool Settling::recover_from_stall(double error, SettlingResult& result) {
  if (result.n_retries >= max_retries_ && error < usable) {
    end_unsettled(result);
    return false;
  }
  retreat("it neither settles nor diverges, " + state_text(result), Trouble::stall, result);
  return true;
}

void Settling::retreat(const std::string& what, Trouble trouble, SettlingResult& result) {
  std::string reason = what;
  if (const std::string cell = simulation_.worst_cell(); !cell.empty())
    reason += ", " + cell;
  const Remedy remedy = simulation_.mend(trouble, gives_up_early_);
  const bool may_retry =
      result.n_retries < max_retries_ && (!gives_up_early_ || remedy.is_sufficient);
  if (may_retry) {
    if (!remedy.is_sufficient)
      simulation_.strengthen_damping();
    be_safer(trouble, remedy.is_sufficient);
  }
  if (remedy.starts_anew) {
    caution_ = caution_at_begin_;
    last_good_ = first_;
  }
  simulation_.restore(last_good_);
  simulation_.stop();
  if (!may_retry)
    give_up(format("diverged at step %u (%s; %s)%s", result.n_steps, reason.c_str(),
                   simulation_.softness().c_str(), what_did_not_help(result.n_retries).c_str()));
  ++result.n_retries;
  simulation_.update_time_step(caution_.step_safety);
  log_.line(format("  %s: %s; back to the last good state, %s, ramp %.1f, time step %.2f ms%s",
                   description_.name.c_str(), reason.c_str(),
                   is_full_correction() ? "full correction"
                                        : format("lag factor %.1f", caution_.lag_factor).c_str(),
                   caution_.gravity_ramp, 1e3 * simulation_.time_step(),
                   remedy.description.empty() ? "" : (", " + remedy.description).c_str()));
}

std::string Settling::what_did_not_help(unsigned n_retries) const {
  if (gives_up_early_)
    return {};
  const std::string text = format(" and %u retries with ", n_retries);
  if (is_full_correction())
    return text +
           "smaller steps and slower ramps did not help; the full correction flutters on "
           "soft bodies, so choose '" +
           description_.section + "/Correction scheme' = relaxed";
  return text + "longer lags, smaller steps and slower ramps did not help";
}

/// Chooses the state to return to, and safer values. A stall needs no smaller steps.
void Settling::be_safer(Trouble trouble, bool keep_lag) {
  if (!keep_lag) {
    // In one correction interval there is no shorter lag than the interval itself.
    const double shortest =
        parameters_.correction_interval * simulation_.time_step() * simulation_.damping_rate();
    if (parameters_.correction_scheme() == CorrectionScheme::relaxed)
      caution_.lag_factor = 2. * std::max(caution_.lag_factor, shortest);
    caution_.tolerance = tolerance_after_retreat;
  }
  // If the load rises faster than the unloaded positions follow, it acts on a body that
  // already hangs.
  caution_.gravity_ramp = std::max(2. * caution_.gravity_ramp, ramp_in_lags * caution_.lag_factor);
  if (trouble == Trouble::divergence) {
    caution_.step_safety *= 0.8;
    caution_.update_interval = std::max(1u, caution_.update_interval / 2);
    if (!has_kept_) // it diverged again from the same state
      last_good_ = first_;
  }
  last_good_error_ = std::numeric_limits<double>::max();
  has_kept_ = false;
  stall_watch_.restart();
}

/// Leaves a state that is nearly settled, or needed no retries, to the caller.
void Settling::end_unsettled(SettlingResult& result) {
  const std::string how =
      format("did not settle in %u steps with %u retries (residual %.1e of the weight, %s %.3f mm; "
             "%s)",
             result.n_steps, result.n_retries, result.residual, description_.distance.c_str(),
             result.distance, simulation_.softness().c_str());
  const bool is_usable = is_fully_loaded_ &&
                         result.residual < usable * parameters_.residual_tolerance &&
                         result.distance < usable * parameters_.position_tolerance;
  if (result.n_retries > 0 && !is_usable)
    give_up(how);
  result.explanation = "The unloading of " + description_.name + " " + how + "; ";
  if (is_fully_loaded_)
    result.explanation += "raise '" + description_.section + "/Maximum steps' or its tolerances.";
  else
    result.explanation += "the load was still rising, so raise '" + description_.section +
                          "/Maximum steps' or 'Damping rate', or shorten 'Gravity ramp'.";
}

void Settling::give_up(const std::string& what) {
  const std::string advice = gives_up_early_ ? "" : search_load();
  caution_ = caution_at_begin_; // the retreats did not help
  throw DivergenceError("The unloading of " + description_.name + " " + what + advice + ".");
}

} // namespace prosup::settling
