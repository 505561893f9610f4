#include "prosup/settling/settling_parameters.h"

#include "prosup/core/parameters.h"

namespace prosup::settling {

using namespace dealii;

const std::vector<std::string>& correction_names() {
  static const std::vector<std::string> names{"relaxed", "full"};
  return names;
}

SettlingParameters::SettlingParameters(double step_safety)
    : correction(correction_names().front()), step_safety(step_safety) {}

CorrectionScheme SettlingParameters::correction_scheme() const {
  return enumerator<CorrectionScheme>(correction, correction_names());
}

void SettlingParameters::declare(ParameterHandler& prm, const Symbols& symbols) {
  prm.add_parameter("Correction scheme", correction,
                    "How the " + symbols.corrected +
                        " is corrected every n steps of length h. relaxed: " + symbols.relaxed +
                        "; stable. full: " + symbols.full +
                        ", as in the paper (its eq. 9); flutters unless the body is stiff or "
                        "strongly damped (docs/unloading.md).",
                    one_of(correction_names()));
  prm.add_parameter("Lag factor", lag_factor,
                    "tau r/rho: the time constant tau of the relaxed correction, times the damping "
                    "rate. Should exceed 1. Units: none.",
                    Patterns::Double(1e-3, 1e6));
  prm.add_parameter("Correction interval", correction_interval,
                    "n, number of time steps between two corrections (n_invert in the paper's "
                    "Fig. 3). Units: none.",
                    Patterns::Integer(1, 100000));
  prm.add_parameter("Gravity ramp", gravity_ramp,
                    "Time over which gravity rises linearly from zero to its full value, times the "
                    "damping rate. Units: none.",
                    Patterns::Double(0., 1e6));
  prm.add_parameter("Residual tolerance", residual_tolerance,
                    "Converged when the norm of the out-of-balance forces is below this fraction "
                    "of the norm of the weight, and the position tolerance is met. Units: none.",
                    Patterns::Double(1e-12, 1.));
  prm.add_parameter("Position tolerance", position_tolerance,
                    "Converged when " + symbols.error +
                        " is below this value, and the residual tolerance is met. Units: mm.",
                    Patterns::Double(1e-9, 10.));
  prm.add_parameter("Maximum steps", max_steps,
                    "Largest number of time steps; a simulation that has not converged by then is "
                    "reported as not settled. Units: none.",
                    Patterns::Integer(1, 100000000));
  prm.add_parameter("Step safety", step_safety,
                    "Time step as a fraction of the estimated critical time step. Units: none.",
                    Patterns::Double(1e-3, 2.));
  prm.add_parameter("Maximum retries", max_retries,
                    "How often a simulation that diverges or stalls may return to a good state and "
                    "continue with " +
                        symbols.remedies + ". Units: none.",
                    Patterns::Integer(0, 100));
}

} // namespace prosup::settling
