#ifndef PROSUP_UNLOADING_UNLOADING_PARAMETERS_H
#define PROSUP_UNLOADING_UNLOADING_PARAMETERS_H

#include <deal.II/base/parameter_acceptor.h>

#include <string>
#include <vector>

#include "prosup/core/units.h"
#include "prosup/mechanics/explicit/damping.h"

namespace prosup::unloading {

/// How the unloaded positions X are corrected every n steps of length h, from
/// the known loaded positions x and the predicted displacement u.
enum class CorrectionScheme {
  relaxed, ///< X <- X + min(1, n h/tau) (x - u - X)
  full     ///< X <- x - u, the paper's (its eq. 9)
};

/// The schemes that can be chosen by name, in the order of the enumerators.
const std::vector<std::string>& correction_names();

/// Parameters of the unloading, section "Unloading"; the same for prone and
/// supine.
class UnloadingParameters : public dealii::ParameterAcceptor {
public:
  UnloadingParameters();
  void declare_parameters(dealii::ParameterHandler& prm) override;

  mechanics::DampingScheme damping_scheme() const;
  CorrectionScheme correction_scheme() const;

  double density = tissue_density;   ///< rho, g/mm^3
  double gravity = standard_gravity; ///< |g|, mm/s^2
  std::string damping;               ///< of mechanics::damping_names()
  double damping_rate = 25.;         ///< r/rho, 1/s
  std::string correction;            ///< of correction_names()
  double lag_factor = 2.5;           ///< tau r/rho, of the relaxed correction
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
