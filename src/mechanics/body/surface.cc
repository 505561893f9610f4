#include "prosup/mechanics/body/surface.h"

namespace prosup::mechanics {

using namespace dealii;

Tensor<2, 3> Surface::curvature(const Tensor<1, 3>& x) const {
  constexpr double step = 0.1; // mm, small against any radius of curvature
  Tensor<2, 3> result;
  for (unsigned d = 0; d < 3; ++d) {
    Tensor<1, 3> ahead = x, behind = x, normal_ahead, normal_behind;
    ahead[d] += step;
    behind[d] -= step;
    distance(ahead, normal_ahead);
    distance(behind, normal_behind);
    for (unsigned c = 0; c < 3; ++c)
      result[c][d] = (normal_ahead[c] - normal_behind[c]) / (2. * step);
  }
  return result;
}

} // namespace prosup::mechanics
