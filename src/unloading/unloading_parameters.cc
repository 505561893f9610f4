#include "prosup/unloading/unloading_parameters.h"

#include "prosup/core/parameters.h"

namespace prosup::unloading {

using namespace dealii;

UnloadingParameters::UnloadingParameters()
    : ParameterAcceptor("Unloading"), SettlingParameters(0.9), damping("lowest-frequency") {}

mechanics::DampingScheme UnloadingParameters::damping_scheme() const {
  return enumerator<mechanics::DampingScheme>(damping, mechanics::damping_names());
}

void UnloadingParameters::declare_parameters(ParameterHandler& prm) {
  prm.add_parameter("Density", density,
                    "rho, mass density of the tissue in the unloaded configuration. Units: g/mm^3.",
                    Patterns::Double(1e-9, 1.));
  prm.add_parameter("Gravity", gravity, "|g|, acceleration of gravity. Units: mm/s^2.",
                    Patterns::Double(0., 1e6));
  prm.add_parameter("Damping scheme", damping,
                    "How kinetic energy is removed. lowest-frequency: r/rho = 2 omega with the "
                    "Rayleigh quotient omega^2 = u.f / u.M u of the present state. adaptive: the "
                    "same with increments of u and f (adaptive dynamic relaxation). fixed: r/rho "
                    "as given. kinetic: velocities are set to zero at each peak of the kinetic "
                    "energy; does not settle while the unloaded configuration is corrected.",
                    one_of(mechanics::damping_names()));
  prm.add_parameter("Damping rate", damping_rate,
                    "r/rho, damping coefficient over density (paper eq. 1), of the fixed scheme; "
                    "the initial value of the others. Units: 1/s.",
                    Patterns::Double(0., 1e6));
  declare(prm, {"unloaded configuration X", "X <- X + min(1, n h/tau) (x - u - X)", "X <- x - u",
                "max |x - u - X|",
                "a smaller time step, a slower ramp and, if the correction is relaxed, a longer "
                "lag"});
  prm.add_parameter(
      "Mass-scaled fraction", scaled_fraction,
      "Fraction of the nodes, those with the smallest critical time step, whose inertial mass "
      "is raised so that they do not limit the time step. The settled state does not depend "
      "on it. Units: none.",
      Patterns::Double(0., 1.));
}

} // namespace prosup::unloading
