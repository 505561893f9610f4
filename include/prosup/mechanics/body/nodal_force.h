#ifndef PROSUP_MECHANICS_NODAL_FORCE_H
#define PROSUP_MECHANICS_NODAL_FORCE_H

#include <deal.II/base/tensor.h>

namespace prosup::mechanics {

/// A force on nodes that depends on their positions, such as a bed of springs. The force on a
/// node depends on that node alone, so that its tangent is a 3 x 3 block.
class NodalForce {
public:
  virtual ~NodalForce() = default;
  /// Computes the force (g mm/s^2) on the local node `node` with unloaded position `X` and
  /// loaded position `x` (mm), and its derivatives with respect to x and X (g/s^2).
  /// @returns false if no force acts on this node; the output is then unchanged.
  virtual bool evaluate(unsigned node, const dealii::Tensor<1, 3>& X, const dealii::Tensor<1, 3>& x,
                        dealii::Tensor<1, 3>& force, dealii::Tensor<2, 3>& by_x,
                        dealii::Tensor<2, 3>& by_X) const = 0;
};

} // namespace prosup::mechanics

#endif
