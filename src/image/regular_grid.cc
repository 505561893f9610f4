#include "regular_grid.h"

#include <deal.II/base/symmetric_tensor.h>

#include <cmath>
#include <stdexcept>

namespace prosup::image {

void make_orthonormal(Tensor<2, 3>& direction) {
  constexpr double tolerance = 1e-3;
  const Tensor<2, 3> axes = transpose(direction);
  for (unsigned d = 0; d < 3; ++d)
    if (!(std::abs(axes[d].norm() - 1.) <= tolerance))
      throw std::domain_error("direction cosines are not of length 1");
  const auto deviation =
      (transpose(direction) * direction - dealii::unit_symmetric_tensor<3>()).norm();
  if (!(deviation <= tolerance))
    throw std::domain_error("axes are not at right angles");
  if (deviation > 1e-14)
    direction = dealii::project_onto_orthogonal_tensors(direction);
}

VoxelGrid regular_grid(const std::array<std::size_t, 3>& size, const VoxelSteps& steps) {
  VoxelGrid grid;
  grid.size = size;
  grid.origin = steps.origin;
  for (unsigned d = 0; d < 3; ++d) {
    grid.spacing[d] = steps.steps[d].norm();
    if (!(grid.spacing[d] > 0.) || !std::isfinite(grid.spacing[d]))
      throw std::domain_error("voxels have no size along axis " + std::to_string(d + 1));
    for (unsigned e = 0; e < 3; ++e)
      grid.direction[e][d] = steps.steps[d][e] / grid.spacing[d];
  }
  make_orthonormal(grid.direction);
  return grid;
}

} // namespace prosup::image
