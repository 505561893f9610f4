#ifndef PROSUP_SRC_UNLOADING_DIVERGENCE_GUARD_H
#define PROSUP_SRC_UNLOADING_DIVERGENCE_GUARD_H

#include <string>
#include <vector>

#include "prosup/unloading/unloading.h"

namespace prosup::unloading {

/// Watches an unloading: tells when it goes wrong and why, keeps good states to
/// go back to, and the values to continue with, which are safer after each
/// return. Collective on the communicator of the body.
class DivergenceGuard {
public:
  DivergenceGuard(const UnloadingParameters& parameters, const mechanics::Body& body,
                  const dealii::Tensor<1, 3>& gravity);

  /// Values that a return makes safer.
  struct Values {
    double lag_factor, step_safety, gravity_ramp; ///< as in the parameters
    unsigned mass_interval;                       ///< corrections between updates of the mass
    double tolerance;                             ///< factor on the tolerances
  };
  const Values& values() const { return values_; }

  void set_material(const mechanics::Material& material);
  /// The energy of a free fall of `mass` (g, of all ranks) through the body's own
  /// height: no settling motion has as much.
  void set_mass(double mass) { kinetic_energy_limit_ = mass * largest_head_; }

  /// A new simulation starts from this state, with all tries to go.
  void begin(Unloading::State state);
  /// Undoes what retreats since then changed: they did not help.
  void forget_retreats() { values_ = values_at_begin_; }
  /// Good are states under the whole load that are nearer to settled than any before:
  /// what comes before, or swings, may be about to diverge.
  bool is_good(double error) const { return error < last_good_error_; }
  void keep(Unloading::State state, double error);

  /// Looks at this rank's smallest J before a step; remembers the first cell to
  /// collapse. Not collective.
  void watch_step(double min_jacobian, const mechanics::InternalForce& internal_force,
                  const NodeVector& displacement);
  /// As before the first step.
  void forget_steps();
  /// What is wrong with a state after the steps watched; empty if nothing is.
  std::string trouble(const mechanics::StepReport& report, double reference_volume) const;
  /// "cell 7 near (1.0, 2.0, 3.0) mm with J = 0.01": the first to collapse of all
  /// ranks or, if none did, the worst one now, at its place in the loaded mesh.
  std::string worst_cell(const mechanics::InternalForce& internal_force,
                         const NodeVector& displacement) const;

  /// Looks at the error of a healthy state over its tolerance, `duration` damping
  /// times after the last look. Does it neither fall nor diverge?
  bool is_stalled(double error, double duration, unsigned n_steps);

  bool may_retry() const { return n_retries_ < max_retries_; }
  /// The state to go on from, the values being safer: the last good one, or where
  /// that led nowhere the first. `correction_lag` is n h r/rho, the shortest lag
  /// there is. What is stalled needs no smaller steps.
  const Unloading::State& retreat(double correction_lag, bool is_stalled);
  const Unloading::State& last_good() const { return last_good_; }
  /// The state with which the simulation began.
  const Unloading::State& first() const { return first_; }
  /// Values that are safe at first, and few tries: for the search for a load.
  void be_careful();

  /// "rho g L/mu = 3.2": the weight of a column as long as the body over its
  /// mean stiffness.
  std::string softness() const;

private:
  const UnloadingParameters& parameters_;
  const mechanics::Body& body_;
  Values values_, values_at_begin_;
  unsigned max_retries_, n_retries_ = 0;
  double largest_head_ = 0.; ///< |g| times the extent along it, mm^2/s^2
  double mean_shear_modulus_ = 0.;
  double kinetic_energy_limit_ = 0.;
  Unloading::State first_, last_good_;
  double last_good_error_ = 0.;
  bool has_kept_ = false; ///< since the last return
  // Of the watch over steps, since the last look for trouble.
  unsigned n_watched_ = 0, first_collapse_ = 0; ///< steps
  std::string collapsed_cell_;
  // Of the watch for stalls.
  double smallest_error_ = 0., smallest_before_ = 0.;
  double window_ = 0.; ///< damping times so far
  unsigned window_first_step_ = 0;
};

} // namespace prosup::unloading

#endif
