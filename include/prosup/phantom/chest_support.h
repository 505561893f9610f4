#ifndef PROSUP_PHANTOM_CHEST_SUPPORT_H
#define PROSUP_PHANTOM_CHEST_SUPPORT_H

#include <vector>

#include "prosup/mechanics/quasi_static.h"
#include "prosup/phantom/geometry.h"

namespace prosup::phantom {

/// A chest on which the tissue slides: nodes are held at their distance r to
/// the axis of the cylinder by a stiff contact, and drawn to where they were by
/// the springs of a loose fascia,
///   f = -A (k_n (r(x) - r(X)) n(x) + k_t (x - X)),
/// A being the lumped area of the node and n the direction away from the axis.
class ChestSupport : public mechanics::NodalForce {
public:
  /// `area` of each local node, mm^2, zero for those off the chest; stiffnesses
  /// of contact and fascia in Pa/mm.
  ChestSupport(const Geometry& geometry, std::vector<double> area, double contact_stiffness,
               double fascia_stiffness);

  bool evaluate(unsigned node, const dealii::Tensor<1, 3>& X, const dealii::Tensor<1, 3>& x,
                dealii::Tensor<1, 3>& force, dealii::Tensor<2, 3>& by_x,
                dealii::Tensor<2, 3>& by_X) const override;

private:
  const double axis_y_;
  const std::vector<double> area_;
  const double contact_, fascia_;
};

} // namespace prosup::phantom

#endif
