#include "prosup/similarity/similarity_parameters.h"

#include <deal.II/base/patterns.h>

#include <algorithm>
#include <utility>

#include "prosup/core/error.h"
#include "prosup/core/parameters.h"
#include "prosup/core/text.h"
#include "prosup/similarity/local_correlation.h"
#include "prosup/similarity/mutual_information.h"
#include "prosup/similarity/sum_of_squared_differences.h"

namespace prosup::similarity {

using namespace dealii;

namespace {

constexpr const char* automatic = "automatic";

using Metrics = std::vector<std::shared_ptr<Metric>>;

std::vector<std::string> names_of(const Metrics& metrics, bool for_different_contrast = false) {
  std::vector<std::string> names;
  for (const auto& metric : metrics)
    if (!for_different_contrast || !metric->needs_same_contrast())
      names.push_back(metric->name());
  return names;
}

Metrics::const_iterator find(const Metrics& metrics, const std::string& name) {
  return std::find_if(metrics.begin(), metrics.end(),
                      [&](const auto& metric) { return metric->name() == name; });
}

} // namespace

std::vector<std::shared_ptr<Metric>> all_metrics() {
  return {
      std::make_shared<SumOfSquaredDifferences>(),
      std::make_shared<NormalisedMutualInformation>(),
      std::make_shared<LocalCorrelation>(),
  };
}

std::vector<std::string> metric_names(bool for_different_contrast) {
  return names_of(all_metrics(), for_different_contrast);
}

SimilarityParameters::SimilarityParameters()
    : ParameterAcceptor("Similarity"), metrics_(all_metrics()) {
  metric = automatic;
}

void SimilarityParameters::declare_parameters(ParameterHandler& prm) {
  std::vector<std::string> descriptions, allowed{automatic};
  for (const auto& known : metrics_)
    descriptions.push_back(known->name() + " (" + known->description() + ")");
  for (const std::string& name : names_of(metrics_))
    allowed.push_back(name);
  prm.add_parameter(
      "Metric", metric,
      "Measure of the difference between the two images, which is minimised. "
      "Allowed: " +
          joined(descriptions) + ". For images of different contrast, such as MR and CT: " +
          joined(names_of(metrics_, true), " or ") + ". automatic: " + metrics_.front()->name() +
          ", or " + LocalCorrelation().name() + " if scans of different contrast are prepared.",
      one_of(allowed));
  prm.add_parameter("Boundary layers", n_layers,
                    "Layers of voxels around the mesh that move with their nearest element. With "
                    "them the skin feels both sides of its edge in the image. Units: voxels.",
                    Patterns::Integer(0, 20));
  prm.add_parameter("Grid margin", margin,
                    "Space around both unloaded meshes in the grid on which they are compared. "
                    "Units: voxels.",
                    Patterns::Double(0., 1000.));
  for (const auto& known : metrics_)
    known->declare_parameters(prm);
}

void SimilarityParameters::add_metric(std::shared_ptr<Metric> new_metric) {
  if (find(metrics_, new_metric->name()) != metrics_.end())
    throw Error("There is a similarity metric '" + new_metric->name() +
                "' already; give the new one another name.");
  metrics_.push_back(std::move(new_metric));
}

bool SimilarityParameters::is_automatic() const {
  return metric == automatic;
}

std::shared_ptr<const Metric> SimilarityParameters::make_metric(bool different_contrast) const {
  const auto found = !is_automatic()      ? find(metrics_, metric)
                     : different_contrast ? find(metrics_, LocalCorrelation().name())
                                          : metrics_.begin();
  if (found == metrics_.end())
    throw Error("There is no similarity metric '" + metric +
                "'; allowed are: " + joined(names_of(metrics_), ", ") + ".");
  return *found;
}

} // namespace prosup::similarity
