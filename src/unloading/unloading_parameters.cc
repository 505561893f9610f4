#include "prosup/unloading/unloading_parameters.h"

#include "prosup/core/parameters.h"

namespace prosup::unloading {

using namespace dealii;

const std::vector<std::string>& correction_names() {
  static const std::vector<std::string> names{"relaxed", "full"};
  return names;
}

UnloadingParameters::UnloadingParameters()
    : ParameterAcceptor("Unloading"), damping("lowest-frequency"),
      correction(correction_names().front()) {}

mechanics::DampingScheme UnloadingParameters::damping_scheme() const {
  return enumerator<mechanics::DampingScheme>(damping, mechanics::damping_names());
}

CorrectionScheme UnloadingParameters::correction_scheme() const {
  return enumerator<CorrectionScheme>(correction, correction_names());
}

void UnloadingParameters::declare_parameters(ParameterHandler& prm) {
  prm.add_parameter("Density", density,
                    "rho, mass density of the tissue in the unloaded configuration. Units: g/mm^3.",
                    Patterns::Double(1e-9, 1.));
  prm.add_parameter("Gravity", gravity, "|g|, acceleration of gravity. Units: mm/s^2.",
                    Patterns::Double(0., 1e6));
  prm.add_parameter("Damping", damping,
                    "How motion is taken out of the simulation. lowest-frequency: r/rho = 2 omega, "
                    "estimated from the motion by omega^2 = u.f / u.M u. adaptive: the same with "
                    "increments of u and f (adaptive dynamic relaxation). fixed: r/rho as given. "
                    "kinetic: velocities are set to zero at each peak of the kinetic energy; does "
                    "not settle with a reference that moves. Units: none.",
                    one_of(mechanics::damping_names()));
  prm.add_parameter("Damping rate", damping_rate,
                    "r/rho, damping coefficient over density (paper eq. 1): of the fixed scheme, "
                    "and of the others until they have an estimate. Units: 1/s.",
                    Patterns::Double(0., 1e6));
  prm.add_parameter(
      "Correction", correction,
      "How the unloaded positions X are corrected every n steps of length h. relaxed: X "
      "<- X + min(1, n h/tau) (x - u - X), stable and exact. full: X <- x - u, as in "
      "the paper; flutters unless the body is stiff or the damping strong "
      "(docs/unloading.md). Units: none.",
      one_of(correction_names()));
  prm.add_parameter("Lag factor", lag_factor,
                    "tau r/rho of the relaxed correction: the time tau in which the unloaded "
                    "positions follow the prediction, times the damping rate. Should be above 1. "
                    "Units: none.",
                    Patterns::Double(1e-3, 1e6));
  prm.add_parameter("Correction interval", correction_interval,
                    "n, steps between two corrections of the unloaded positions. Units: none.",
                    Patterns::Integer(1, 100000));
  prm.add_parameter(
      "Gravity ramp", gravity_ramp,
      "Time in which gravity rises linearly to its full value, times the damping rate. "
      "Units: none.",
      Patterns::Double(0., 1e6));
  prm.add_parameter(
      "Residual tolerance", residual_tolerance,
      "Stop when the norm of the out-of-balance nodal forces is below this part of the "
      "norm of the weight. Units: none.",
      Patterns::Double(1e-12, 1.));
  prm.add_parameter("Position tolerance", position_tolerance,
                    "Stop when also max |x - u - X| is below this. Units: mm.",
                    Patterns::Double(1e-9, 10.));
  prm.add_parameter("Maximum steps", max_steps, "Give up after this many time steps. Units: none.",
                    Patterns::Integer(1, 100000000));
  prm.add_parameter("Step safety", step_safety,
                    "Time step over the estimate of the critical one. Units: none.",
                    Patterns::Double(1e-3, 2.));
  prm.add_parameter(
      "Mass-scaled fraction", scaled_fraction,
      "Part of the nodes, those with the smallest critical step, whose inertial mass is "
      "raised so that they do not rule the time step. The settled state does not depend "
      "on it. Units: none.",
      Patterns::Double(0., 1.));
  prm.add_parameter(
      "Maximum retries", max_retries,
      "How often a simulation that diverges, or gets no nearer, goes back to a good state and "
      "continues with a smaller step, a slower ramp and, if the correction is relaxed, a longer "
      "lag. Units: none.",
      Patterns::Integer(0, 100));
}

} // namespace prosup::unloading
