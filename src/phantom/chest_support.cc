#include "prosup/phantom/chest_support.h"

#include <cmath>
#include <utility>

namespace prosup::phantom {

using dealii::Tensor;

namespace {

/// Vector from the axis (along z through y = axis_y) to a point.
Tensor<1, 3> from_axis(const Tensor<1, 3>& x, double axis_y) {
  return Tensor<1, 3>({x[0], x[1] - axis_y, 0.});
}

} // namespace

ChestSupport::ChestSupport(const Geometry& geometry, std::vector<double> area,
                           double contact_stiffness, double fascia_stiffness)
    : axis_y_(geometry.chest_radius), area_(std::move(area)), contact_(contact_stiffness),
      fascia_(fascia_stiffness) {}

bool ChestSupport::evaluate(unsigned node, const Tensor<1, 3>& X, const Tensor<1, 3>& x,
                            Tensor<1, 3>& force, Tensor<2, 3>& by_x, Tensor<2, 3>& by_X) const {
  const double area = area_[node];
  if (!(area > 0.))
    return false;
  const Tensor<1, 3> along = from_axis(x, axis_y_), along_before = from_axis(X, axis_y_);
  const double r = along.norm(), r_before = along_before.norm(), gap = r - r_before;
  const Tensor<1, 3> n = along / r, n_before = along_before / r_before;
  Tensor<2, 3> across, identity; // across the axis
  across[0][0] = across[1][1] = 1.;
  identity = across;
  identity[2][2] = 1.;

  force = -area * (contact_ * gap * n + fascia_ * (x - X));
  // d(gap n)/dx = n n + gap/r (1 - n n), in the plane across the axis
  by_x = -area * (contact_ * ((1. - gap / r) * outer_product(n, n) + gap / r * across) +
                  fascia_ * identity);
  by_X = area * (contact_ * outer_product(n, n_before) + fascia_ * identity);
  return true;
}

} // namespace prosup::phantom
