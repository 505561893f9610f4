#ifndef PROSUP_MECHANICS_SURFACE_H
#define PROSUP_MECHANICS_SURFACE_H

#include <deal.II/base/tensor.h>

namespace prosup::mechanics {

/// A family of parallel smooth surfaces: the level sets of a distance.
class Surface {
public:
  virtual ~Surface() = default;

  /// Signed distance of x from the surface of distance 0, mm, positive on the side of the tissue.
  /// Writes the unit normal, the direction in which the distance grows.
  virtual double distance(const dealii::Tensor<1, 3>& x, dealii::Tensor<1, 3>& normal) const = 0;

  /// Derivative of the unit normal with respect to x, 1/mm; by finite differences unless
  /// overridden.
  virtual dealii::Tensor<2, 3> curvature(const dealii::Tensor<1, 3>& x) const;
};

/// Planes with a common unit normal.
class ParallelPlanes : public Surface {
public:
  explicit ParallelPlanes(const dealii::Tensor<1, 3>& normal) : normal_(normal) {}
  double distance(const dealii::Tensor<1, 3>& x, dealii::Tensor<1, 3>& normal) const override {
    normal = normal_;
    return normal_ * x;
  }
  dealii::Tensor<2, 3> curvature(const dealii::Tensor<1, 3>&) const override { return {}; }

private:
  const dealii::Tensor<1, 3> normal_;
};

} // namespace prosup::mechanics

#endif
