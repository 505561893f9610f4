#ifndef PROSUP_FDM_MATERIAL_H
#define PROSUP_FDM_MATERIAL_H

#include <map>

#include "prosup/core/units.h"

namespace prosup::fdm {

/// Lame parameters of a neo-Hookean tissue, Pa.
struct LameParameters {
  double mu;
  double lambda;
};

/// The tissues of a breast.
struct Material {
  std::map<unsigned, LameParameters> tissues; ///< by label
  double density = tissue_density;            ///< rho, g/mm^3, of all
};

} // namespace prosup::fdm

#endif
