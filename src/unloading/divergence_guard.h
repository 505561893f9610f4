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

  /// Values of the parameters that a return makes safer.
  struct Values {
    double lag_factor, step_safety, gravity_ramp;
  };
  const Values& values() const { return values_; }

  void set_material(const std::vector<mechanics::LameParameters>& material);
  /// The energy of a free fall of `mass` (g, of all ranks) through the body's own
  /// height: no settling motion has as much.
  void set_mass(double mass) { kinetic_energy_limit_ = mass * largest_head_; }

  /// A new simulation starts from this state, with all tries to go.
  void begin(Unloading::State state);
  void keep(Unloading::State state);

  /// What is wrong with a state; empty if nothing is.
  std::string trouble(const mechanics::StepReport& report, double reference_volume) const;
  /// "cell 7 near (1.0, 2.0, 3.0) mm has J = 0.01": the worst one of all ranks, at
  /// its place in the loaded mesh. Empty if there is none but not a number.
  std::string worst_cell(const mechanics::InternalForce& internal_force,
                         const NodeVector& displacement) const;

  /// Looks at the error of a healthy state over its tolerance. Does it neither
  /// fall nor diverge? `elapsed` is time in damping times.
  bool is_stalled(double error, double elapsed, unsigned n_steps);
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
  Values values_;
  unsigned max_retries_, n_retries_ = 0;
  double largest_head_ = 0.; ///< |g| times the extent along it, mm^2/s^2
  double mean_shear_modulus_ = 0.;
  double kinetic_energy_limit_ = 0.;
  Unloading::State first_, last_good_;
  bool has_kept_ = false; ///< since the last return
  // Of the watch for stalls.
  double smallest_error_ = 0., smallest_before_ = 0., window_start_ = 0.;
  unsigned window_first_step_ = 0;
};

} // namespace prosup::unloading

#endif
