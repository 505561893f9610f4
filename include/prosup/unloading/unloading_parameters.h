#ifndef PROSUP_UNLOADING_UNLOADING_PARAMETERS_H
#define PROSUP_UNLOADING_UNLOADING_PARAMETERS_H

#include <deal.II/base/parameter_acceptor.h>

#include "prosup/core/units.h"
#include "prosup/mechanics/damping.h"

namespace prosup::unloading {

/// Parameters of the unloading, section "Unloading"; the same for prone and
/// supine.
class UnloadingParameters : public dealii::ParameterAcceptor {
public:
  UnloadingParameters();
  void declare_parameters(dealii::ParameterHandler& prm) override;

  mechanics::DampingScheme damping_scheme() const;

  double density = tissue_density;   ///< rho, g/mm^3
  double gravity = standard_gravity; ///< |g|, mm/s^2
  std::string damping;               ///< of mechanics::damping_names()
  double damping_rate = 25.;         ///< r/rho, 1/s
  double lag_factor = 2.5;           ///< tau r/rho
  unsigned correction_interval = 10; ///< n, steps
  double gravity_ramp = 1.;          ///< times the damping time
  double residual_tolerance = 2e-3;  ///< relative
  double position_tolerance = 0.02;  ///< mm
  unsigned max_steps = 20000;
  double step_safety = 0.9;    ///< of the critical time step
  double scaled_fraction = 1.; ///< of the nodes
  unsigned max_retries = 6;
};

} // namespace prosup::unloading

#endif
