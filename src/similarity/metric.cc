#include "prosup/similarity/metric.h"

#include "prosup/core/error.h"

namespace prosup::similarity {

double SumOfSquaredDifferences::evaluate(const WarpedPair& pair,
                                         VoxelDerivatives& derivatives) const {
  const double volume = pair.grid.voxel_volume();
  const std::size_t n = pair.in_domain.size();
  for (unsigned s = 0; s < 2; ++s) {
    derivatives.slope[s].assign(n, 0.f);
    derivatives.curvature[s].assign(n, 0.f);
  }
  double sum = 0.;
  for (std::size_t v = 0; v < n; ++v) {
    if (!pair.in_domain[v])
      continue;
    const double difference = pair.values[prone][v] - pair.values[supine][v];
    sum += difference * difference;
    derivatives.slope[prone][v] = static_cast<float>(volume * difference);
    derivatives.slope[supine][v] = static_cast<float>(-volume * difference);
    for (std::vector<float>& curvature : derivatives.curvature)
      curvature[v] = static_cast<float>(volume);
  }
  return 0.5 * volume * sum;
}

const std::vector<std::string>& metric_names() {
  static const std::vector<std::string> names{"ssd"};
  return names;
}

std::unique_ptr<Metric> make_metric(const std::string& name) {
  if (name == "ssd")
    return std::make_unique<SumOfSquaredDifferences>();
  std::string allowed;
  for (const std::string& known : metric_names())
    allowed += (allowed.empty() ? "" : ", ") + known;
  throw Error("There is no similarity metric '" + name + "'; allowed are: " + allowed + ".");
}

} // namespace prosup::similarity
