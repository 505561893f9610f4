#include "prosup/registration/material_update.h"

#include <algorithm>
#include <cmath>

#include "property_search.h"
#include "prosup/core/parameters.h"
#include "stage_forecast.h"

namespace prosup::registration {

using namespace dealii;

namespace {

const std::vector<std::string> method_names{"search", "stepwise", "none"};
const std::vector<std::string> compared_names{"automatic", "images", "tissues"};

// Of a step, over that on the level before: most of it is unloading, whatever the voxels.
constexpr double cost_of_finer_level = 1.25;

/// Multiplies by `factor` while the similarity improves.
void walk(PropertyTrials& trials, double factor, const MaterialProgress& progress,
          unsigned max_steps, const Keeper& keep) {
  while (progress.n_accepted < max_steps) {
    keep();
    MechanicalProperties properties = trials.best();
    properties.tissue.shear_modulus *= factor;
    const bool found = trials.unload(properties);
    const double value = found ? trials.value() : 0.;
    if (!found || !(value < trials.best_value()))
      break;
    trials.accept(value);
  }
  trials.return_to_best();
}

} // namespace

MaterialUpdate::MaterialUpdate()
    : ParameterAcceptor("Material update"), method_(method_names.front()),
      compared_(compared_names.front()), properties_(property_names()) {
  properties_.erase(std::find(properties_.begin(), properties_.end(), "skin stiffness"));
}

void MaterialUpdate::declare_parameters(ParameterHandler& prm) {
  prm.add_parameter("Method", method_,
                    "search: Gauss-Newton steps for all chosen properties at once. stepwise: the "
                    "paper's steps of the shear modulus. none: the properties stay as given.",
                    one_of(method_names));
  prm.add_parameter(
      "Compared quantity", compared_,
      "images: the images, with the metric of section Similarity. tissues: fat and "
      "gland as labelled, by squared differences. automatic: the tissues if the metric is for "
      "images of different contrast, else the images.",
      one_of(compared_names));
  prm.add_parameter(
      "Properties", properties_,
      "What the search may change, from the values given under Material and "
      "Supports. The gland ratio only counts where there is gland, the stiffness of chest and cut "
      "planes where there are springs. Gravity turns about the axes perpendicular to the direction "
      "given, and there is a skin, with fe only. The skin is not among the default: it takes "
      "more steps, up to five times as many, and changes the error of known cases by hundredths of "
      "a mm.",
      Patterns::List(*one_of(property_names()).clone(), 0, property_names().size()));
  prm.add_parameter("Levels", levels_,
                    "Edges of the voxels on which the images are compared, from coarse to fine. "
                    "Stepwise uses the last one. Units: mm.",
                    Patterns::List(Patterns::Double(0.1, 50.), 1, 20));
  prm.add_parameter("Maximum steps", max_steps_,
                    "Largest number of accepted steps on a level. Units: none.",
                    Patterns::Integer(0, 1000));
  prm.add_parameter(
      "Least gain", least_gain_,
      "A search ends with a step that lowers the similarity by less than this part of all that "
      "was gained on its level. Units: none.",
      Patterns::Double(0., 1.));
  prm.add_parameter(
      "Correlation length", correlation_length_,
      "L: what the images say counts as V/L^3 independent measurements of a breast of "
      "volume V against the prior of the properties. The less the images agree in "
      "the end, the more the prior counts. 0: no prior. Units: mm.",
      Patterns::Double(0., 1e3));
  prm.add_parameter(
      "Factor", factor_,
      "Factor on the shear modulus of one step of stepwise, used both ways (paper: 1.1 clinical, "
      "1.2 phantom). Units: none.",
      Patterns::Double(1.0001, 10.));
}

bool MaterialUpdate::searches() const {
  return method_ == "stepwise" ||
         (method_ == "search" && std::find(properties_.begin(), properties_.end(),
                                           property_names().front()) != properties_.end());
}

MaterialUpdateResult MaterialUpdate::run(BreastPair& pair, const ComparedImages& images,
                                         const Log& log, const Observer& observer) const {
  MaterialProgress progress;
  run(pair, images, log, observer, progress, [] {});
  return progress.result;
}

void MaterialUpdate::run(BreastPair& pair, const ComparedImages& images, const Log& log,
                         const Observer& observer, MaterialProgress& progress,
                         const Keeper& keep) const {
  if (method_ == "none")
    return;
  const bool by_images =
      compared_ == "images" || (compared_ == "automatic" && images.metric->needs_same_contrast());
  const auto trials_on = [&](double level, const Observer& told) {
    return PropertyTrials(pair,
                          Comparison(pair, images, by_images ? Compared::images : Compared::tissues,
                                     level, progress.grid),
                          correlation_length_, log, told, progress);
  };
  if (method_ == "stepwise") {
    PropertyTrials trials = trials_on(levels_.back(), observer);
    if (!progress.walks_back)
      walk(trials, factor_, progress, max_steps_, keep);
    progress.walks_back = progress.walks_back || progress.n_accepted == 0;
    if (progress.walks_back)
      walk(trials, 1. / factor_, progress, max_steps_, keep);
    return;
  }
  std::vector<double> costs;
  for (std::size_t level = 0; level < levels_.size(); ++level)
    costs.push_back(std::pow(cost_of_finer_level, level));
  StageForecast forecast(levels_, {costs, least_gain_}, observer);
  const Observer told = forecast.observer();
  while (progress.level < levels_.size()) {
    const double level = levels_[progress.level];
    PropertyTrials trials = trials_on(level, told);
    search_properties(properties_, trials, progress, max_steps_, least_gain_,
                      level == levels_.back(), keep);
    ++progress.level;
    progress.grid = {};
    progress.derivatives.clear();
    keep();
  }
  progress.result.at_bound =
      properties_at_bound(properties_, pair.properties(), PropertiesOfPair(pair));
}

} // namespace prosup::registration
