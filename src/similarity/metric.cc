#include "prosup/similarity/metric.h"

#include <cmath>
#include <utility>

namespace prosup::similarity {

void VoxelDerivatives::reset(std::size_t n_voxels) {
  for (const Position p : both_positions) {
    slope[p].assign(n_voxels, 0.f);
    curvature[p].assign(n_voxels, 0.f);
  }
}

std::vector<float> residuals_of(VoxelDerivatives derivatives) {
  std::vector<float> residuals = std::move(derivatives.slope.prone);
  const std::vector<float>& curvature = derivatives.curvature.prone;
  for (std::size_t v = 0; v < residuals.size(); ++v)
    residuals[v] = curvature[v] > 0.f ? residuals[v] / std::sqrt(curvature[v]) : 0.f;
  return residuals;
}

} // namespace prosup::similarity
