#include "prosup/mechanics/laws/material.h"

namespace prosup::mechanics {

LameParameters lame_parameters(double shear_modulus, double poisson_ratio) {
  return {shear_modulus, 2. * shear_modulus * poisson_ratio / (1. - 2. * poisson_ratio)};
}

} // namespace prosup::mechanics
