#include "prosup/registration/mechanical_properties.h"

#include <cmath>

namespace prosup::registration {

using namespace dealii;

std::array<double, 2> Tilt::degrees() const {
  return {180. / numbers::PI * left, 180. / numbers::PI * superior};
}

Tensor<1, 3> tilted(const Tensor<1, 3>& gravity, const Tilt& tilt) {
  const Tensor<1, 3> g = gravity / gravity.norm();
  Tensor<1, 3> left;
  left[0] = 1.;
  if (std::abs(g[0]) > 0.9) { // gravity acts along it: a side position
    left[0] = 0.;
    left[1] = 1.;
  }
  left -= (left * g) * g;
  left /= left.norm();
  Tensor<1, 3> superior = cross_product_3d(left, g);
  if (superior[2] < 0.)
    superior *= -1.;
  const Tensor<1, 3> direction =
      g + std::tan(tilt.left) * left + std::tan(tilt.superior) * superior;
  return direction / direction.norm();
}

} // namespace prosup::registration
