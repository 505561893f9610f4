#ifndef PROSUP_UNLOADING_UNLOADING_PARAMETERS_H
#define PROSUP_UNLOADING_UNLOADING_PARAMETERS_H

#include <deal.II/base/parameter_acceptor.h>

#include <string>

#include "prosup/core/units.h"
#include "prosup/mechanics/explicit/damping.h"
#include "prosup/settling/settling_parameters.h"

namespace prosup::unloading {

/// Parameters of the unloading by finite elements, section "Unloading"; the same for
/// prone and supine.
class UnloadingParameters : public dealii::ParameterAcceptor, public settling::SettlingParameters {
public:
  UnloadingParameters();
  void declare_parameters(dealii::ParameterHandler& prm) override;

  mechanics::DampingScheme damping_scheme() const;

  double density = tissue_density;   ///< rho, g/mm^3
  double gravity = standard_gravity; ///< |g|, mm/s^2
  std::string damping;               ///< of mechanics::damping_names()
  double damping_rate = 25.;         ///< r/rho, 1/s
  double scaled_fraction = 1.;       ///< of the nodes
};

} // namespace prosup::unloading

#endif
