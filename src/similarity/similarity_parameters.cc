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
  metric = metrics_.front()->name();
}

void SimilarityParameters::declare_parameters(ParameterHandler& prm) {
  std::vector<std::string> descriptions;
  for (const auto& known : metrics_)
    descriptions.push_back(known->name() + " (" + known->description() + ")");
  prm.add_parameter("Metric", metric,
                    "Measure of the difference between the two images, which is minimised. "
                    "Allowed: " +
                        joined(descriptions) +
                        ". For images of different contrast, such as MR and CT: " +
                        joined(names_of(metrics_, true), " or ") + ".",
                    one_of(names_of(metrics_)));
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

std::shared_ptr<const Metric> SimilarityParameters::make_metric() const {
  const auto found = find(metrics_, metric);
  if (found == metrics_.end())
    throw Error("There is no similarity metric '" + metric +
                "'; allowed are: " + joined(names_of(metrics_), ", ") + ".");
  return *found;
}

} // namespace prosup::similarity
