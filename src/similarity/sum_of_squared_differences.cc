#include "prosup/similarity/sum_of_squared_differences.h"

namespace prosup::similarity {

double SumOfSquaredDifferences::evaluate(const WarpedPair& pair,
                                         VoxelDerivatives& derivatives) const {
  const double volume = pair.grid.voxel_volume();
  const std::size_t n = pair.in_domain.size();
  derivatives.reset(n);
  double sum = 0.;
  for (std::size_t v = 0; v < n; ++v) {
    if (!pair.in_domain[v])
      continue;
    const double difference = pair.values.prone[v] - pair.values.supine[v];
    sum += difference * difference;
    derivatives.slope.prone[v] = static_cast<float>(volume * difference);
    derivatives.slope.supine[v] = static_cast<float>(-volume * difference);
    derivatives.curvature.prone[v] = static_cast<float>(volume);
    derivatives.curvature.supine[v] = static_cast<float>(volume);
  }
  return 0.5 * volume * sum;
}

} // namespace prosup::similarity
