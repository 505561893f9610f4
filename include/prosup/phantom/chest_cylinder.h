#ifndef PROSUP_PHANTOM_CHEST_CYLINDER_H
#define PROSUP_PHANTOM_CHEST_CYLINDER_H

#include "prosup/mechanics/body/surface.h"
#include "prosup/phantom/geometry.h"

namespace prosup::phantom {

/// The surface of the phantom's chest, on which tissue can slide.
class ChestCylinder : public mechanics::Surface {
public:
  explicit ChestCylinder(const Geometry& geometry) : radius_(geometry.chest_radius) {}

  /// Distance to the axis minus the radius, mm.
  double distance(const dealii::Tensor<1, 3>& x, dealii::Tensor<1, 3>& normal) const override;
  dealii::Tensor<2, 3> curvature(const dealii::Tensor<1, 3>& x) const override;

private:
  const double radius_;
};

} // namespace prosup::phantom

#endif
