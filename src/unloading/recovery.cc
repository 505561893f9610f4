// What Unloading does when it diverges or gets no nearer.

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <utility>

#include "divergence_guard.h"
#include "prosup/core/error.h"

namespace prosup::unloading {

using namespace dealii;

namespace {

// The search for the part of gravity that can be unloaded: to 1/32 of it.
constexpr unsigned n_tries = 5, steps_per_try = 6000;

// Error over its tolerance: an unsettled state that is of use.
constexpr double near = 10.;

} // namespace

/// Returns whether the simulation may go on. @throws as run().
bool Unloading::recover_from_stall(double error, UnloadingResult& result) {
  if (!guard_->may_retry() && error < near) {
    end_unsettled(result);
    return false;
  }
  retreat(format("it neither settles nor diverges, residual %.1e, max |x-u-X| %.3f mm",
                 result.residual, result.distance),
          true, result);
  return true;
}

void Unloading::retreat(const std::string& trouble, bool is_stalled, UnloadingResult& result) {
  state_.displacement.update_ghost_values();
  std::string reason = trouble;
  if (const std::string cell = guard_->worst_cell(internal_force_, state_.displacement);
      !cell.empty())
    reason += ", " + cell;
  const bool changes_damping =
      is_stalled && damping_.mend_fixed_rate(integrator_, state_.displacement, external_force_);
  // Who asks for the paper's scheme gets it to the end.
  const bool is_full =
      !holds_reference_ && parameters_.correction_scheme() == CorrectionScheme::full;
  const bool may_retry = guard_->may_retry();
  if (may_retry) {
    damping_.strengthen();
    guard_->retreat(parameters_.correction_interval * integrator_.time_step() *
                        damping_.time_scale(),
                    is_stalled);
  }
  restore(guard_->last_good());
  state_.velocity = 0.;
  integrator_.velocity() = 0.;
  if (!may_retry)
    give_up(
        format("diverged at step %u (%s; %s) and %u retries with %ssmaller steps and slower ramps "
               "did not help%s",
               result.n_steps, reason.c_str(), guard_->softness().c_str(), result.n_retries,
               is_full ? "" : "longer lags, ",
               is_full ? "; the full correction flutters on soft bodies, so choose "
                         "'Unloading/Correction' = relaxed"
                       : ""));
  ++result.n_retries;
  update_mass();
  log_.line(format("  %s: %s; back to the last good state, %s, ramp %.1f, time step %.2f ms%s",
                   name_.c_str(), reason.c_str(),
                   is_full ? "full correction"
                           : format("lag factor %.1f", guard_->values().lag_factor).c_str(),
                   guard_->values().gravity_ramp, 1e3 * integrator_.time_step(),
                   changes_damping ? ", damping from the lowest frequency" : ""));
}

/// A state that is near, or of a body that needed no retries, is left to the caller.
void Unloading::end_unsettled(UnloadingResult& result) {
  const std::string how = format("did not settle in %u steps with %u retries (residual %.1e of the "
                                 "weight, max |x-u-X| %.3f mm; %s)",
                                 result.n_steps, result.n_retries, result.residual, result.distance,
                                 guard_->softness().c_str());
  const bool is_near = fully_loaded_ && result.residual < near * parameters_.residual_tolerance &&
                       result.distance < near * parameters_.position_tolerance;
  if (result.n_retries > 0 && !is_near)
    give_up(how);
  result.explanation =
      "The unloading of " + name_ + " " + how +
      (fully_loaded_ ? "; raise 'Unloading/Maximum steps' or its tolerances."
                     : "; the load was still rising, so raise 'Unloading/Maximum steps' or "
                       "'Damping rate', or shorten 'Gravity ramp'.");
}

void Unloading::give_up(const std::string& what) {
  const std::string advice = search_load();
  guard_->forget_retreats();
  throw DivergenceError("The unloading of " + name_ + " " + what + advice + ".");
}

/// Says up to which part of gravity the body settles. Whoever has seen it settle
/// tries other things, and only has to know that they fail.
std::string Unloading::search_load() {
  if (has_settled_ || gravity_to_ < 1. || parameters_.gravity <= 0.)
    return "; the body may be too soft for its load, so raise 'Material/Shear modulus' or check "
           "the mask and mesh there";
  log_.line("  " + name_ + ": looking for the part of its weight under which it settles");
  const State last_good = guard_->last_good();
  State settled_state = guard_->first();
  const Observer observer = std::exchange(observer_, nullptr);
  double settled = 0., failed = 1.;
  for (unsigned i = 0; i < n_tries; ++i) {
    gravity_from_ = settled;
    gravity_to_ = 0.5 * (settled + failed);
    restore(settled_state);
    state_.loading = 0.;
    guard_->be_careful();
    update_mass();
    if (settles()) {
      settled = gravity_to_;
      settled_state = save();
    } else
      failed = gravity_to_;
  }
  gravity_from_ = 0.;
  gravity_to_ = 1.;
  has_settled_ = false;
  observer_ = observer;
  restore(last_good);
  const char* const state = holds_reference_ ? "a loaded state" : "an unloaded state";
  if (settled == 0.)
    return format(
        "; %s was not even found for %.2f of the weight, so check the mask and mesh there, "
        "and 'Material'",
        state, failed);
  return format("; %s exists up to %.2f of the weight and was not found for %.2f, so raise "
                "'Material/Shear modulus' or check the mask and mesh there",
                state, settled, failed);
}

bool Unloading::settles() {
  try {
    return simulate(std::min(steps_per_try, parameters_.max_steps), true).converged;
  } catch (const DivergenceError&) {
    return false;
  }
}

} // namespace prosup::unloading
