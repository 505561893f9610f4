#include "prosup/similarity/metric.h"

#include <cmath>
#include <utility>

#include "prosup/core/error.h"
#include "prosup/similarity/local_correlation.h"
#include "prosup/similarity/mutual_information.h"

namespace prosup::similarity {

void VoxelDerivatives::reset(std::size_t n_voxels) {
  for (unsigned s = 0; s < 2; ++s) {
    slope[s].assign(n_voxels, 0.f);
    curvature[s].assign(n_voxels, 0.f);
  }
}

double SumOfSquaredDifferences::evaluate(const WarpedPair& pair,
                                         VoxelDerivatives& derivatives) const {
  const double volume = pair.grid.voxel_volume();
  const std::size_t n = pair.in_domain.size();
  derivatives.reset(n);
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
  static const std::vector<std::string> names{"ssd", "nmi", "lncc"};
  return names;
}

std::unique_ptr<Metric> make_metric(const std::string& name, const MetricParameters& parameters) {
  if (name == "ssd")
    return std::make_unique<SumOfSquaredDifferences>();
  if (name == "nmi")
    return std::make_unique<NormalisedMutualInformation>(parameters.n_bins);
  if (name == "lncc")
    return std::make_unique<LocalCorrelation>(parameters.window_radius, parameters.noise);
  std::string allowed;
  for (const std::string& known : metric_names())
    allowed += (allowed.empty() ? "" : ", ") + known;
  throw Error("There is no similarity metric '" + name + "'; allowed are: " + allowed + ".");
}

std::vector<float> residuals_of(VoxelDerivatives derivatives) {
  std::vector<float> residuals = std::move(derivatives.slope[prone]);
  const std::vector<float>& curvature = derivatives.curvature[prone];
  for (std::size_t v = 0; v < residuals.size(); ++v)
    residuals[v] = curvature[v] > 0.f ? residuals[v] / std::sqrt(curvature[v]) : 0.f;
  return residuals;
}

} // namespace prosup::similarity
