#include "prosup/phantom/chest_cylinder.h"

#include <cmath>

namespace prosup::phantom {

using dealii::Tensor;

double ChestCylinder::distance(const Tensor<1, 3>& x, Tensor<1, 3>& normal) const {
  const double r = std::hypot(x[0], x[1] - radius_);
  normal = Tensor<1, 3>({x[0] / r, (x[1] - radius_) / r, 0.});
  return r - radius_;
}

Tensor<2, 3> ChestCylinder::curvature(const Tensor<1, 3>& x) const {
  Tensor<1, 3> n;
  const double r = distance(x, n) + radius_;
  Tensor<2, 3> result = -1. / r * outer_product(n, n);
  result[0][0] += 1. / r;
  result[1][1] += 1. / r;
  return result;
}

} // namespace prosup::phantom
