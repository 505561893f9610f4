#include "property_trials.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "prosup/core/error.h"

namespace prosup::registration {

namespace {

/// What has not settled by then, several times the steps of a first unloading, hardly
/// will, and no step of the search is worth the time.
constexpr unsigned max_trial_steps = 3000;

// Motion of the node that moves most, in voxels, over which residuals are differentiated: shorter
// than the textures of the images, derivatives would say nothing about the next step.
constexpr double reach = 1.;
constexpr double least_jacobian = 0.3; // where a trial may start

constexpr double filled_part = 0.5; // of the box around a breast

} // namespace

PropertiesOfPair::PropertiesOfPair(const BreastPair& pair)
    : has_gland(pair.has_gland()),
      can_tilt(pair.all([](const Breast& breast) { return breast.knows_gravity(); })),
      consists_of_elements(pair.consists_of_elements()) {}

PropertyTrials::PropertyTrials(BreastPair& pair, Comparison comparison, double correlation_length,
                               const Log& log, const Observer& observer, MaterialProgress& progress)
    : pair_(pair), comparison_(std::move(comparison)), log_(log), observer_(observer),
      progress_(progress), has_(pair), can_derive_(PropertyResponse::applies_to(pair)),
      best_properties_(pair.properties()) {
  pair_.save();
  if (progress_.grid.n_voxels() > 0)
    return;
  progress_.grid = comparison_.domain().grid;
  progress_.n_independent =
      correlation_length > 0.
          ? pair_volume() / (correlation_length * correlation_length * correlation_length)
          : 0.;
  progress_.n_accepted = 0;
  progress_.first_value = progress_.best_value = comparison_.value();
  report(progress_.best_value);
}

double PropertyTrials::pair_volume() const {
  similarity::Box box;
  pair_.for_each([&](Position, Breast& breast) { box.include(breast.unloaded_box()); });
  const image::VoxelGrid grid =
      similarity::common_grid(box, comparison_.level(), 0., pair_.ranks().world());
  return filled_part * static_cast<double>(grid.n_voxels()) * grid.voxel_volume();
}

double PropertyTrials::prior_weight(double left) const {
  return progress_.n_independent > 0. ? 2. * left / progress_.n_independent : 0.;
}

bool PropertyTrials::unload(const MechanicalProperties& properties) {
  MaterialUpdateResult& result = progress_.result;
  ++result.n_trials;
  try {
    pair_.set_properties(properties);
    if (response_)
      move_towards(properties);
    const auto unloaded = pair_.unload(max_trial_steps);
    result.n_steps += unloaded.prone.n_steps + unloaded.supine.n_steps;
    converged_ = unloaded.prone.converged && unloaded.supine.converged;
    if (response_)
      response_->balance();
    return unloaded.prone.n_steps < max_trial_steps && unloaded.supine.n_steps < max_trial_steps;
  } catch (const Error& error) {
    log_.line("  trial rejected, with " + in_words(properties) + ": " + error.what());
    return false;
  }
}

std::optional<PropertyTrials::Linearization>
PropertyTrials::linearize(const std::vector<const SearchedProperty*>& searched) {
  searched_ = searched;
  try {
    response_.emplace(pair_, searched);
  } catch (const Error& error) {
    log_.line(std::string("  derivatives from trials: ") + error.what());
    can_derive_ = false;
    return_to_best();
    return std::nullopt;
  }
  pair_.save();
  progress_.best_value = comparison_.value();
  Linearization result{residuals(), {}};
  for (unsigned i = 0; i < searched.size(); ++i)
    result.derivatives.push_back(derivative(i, result.residuals));
  return_to_best();
  return result;
}

/// Of the residuals by one property, of which they are `before` at the best state.
std::vector<float> PropertyTrials::derivative(unsigned property,
                                              const std::vector<float>& before) const {
  const double motion = response_->largest_motion(property);
  if (!(motion > 0.))
    return std::vector<float>(before.size(), 0.f);
  const double longest = searched_[property]->difference;
  std::vector<double> change(searched_.size(), 0.);
  change[property] =
      std::copysign(std::min(reach * comparison_.level() / motion, std::abs(longest)), longest);
  if (!(response_->move(change) > 0.))
    return std::vector<float>(before.size(), 0.f);
  std::vector<float> result = residuals();
  for (std::size_t v = 0; v < before.size(); ++v)
    result[v] = static_cast<float>((result[v] - before[v]) / change[property]);
  return result;
}

/// To where the derivatives lead, or as far as no element is nearly crushed.
void PropertyTrials::move_towards(const MechanicalProperties& properties) const {
  std::vector<double> change;
  for (const SearchedProperty* property : searched_)
    change.push_back(property->get(properties) - property->get(best_properties_));
  for (unsigned halvings = 0; halvings < 4; ++halvings) {
    if (response_->move(change) > least_jacobian)
      return;
    for (double& part : change)
      part *= 0.5;
  }
  pair_.restore();
}

void PropertyTrials::accept(double value) {
  response_.reset();
  progress_.best_value = value;
  best_properties_ = pair_.properties();
  pair_.save();
  progress_.result.converged = converged_;
  ++progress_.n_accepted;
  report(value);
}

void PropertyTrials::return_to_best() {
  pair_.set_properties(best_properties_);
  pair_.restore();
}

std::string PropertyTrials::in_words(const MechanicalProperties& properties) const {
  const mechanics::TissueStiffness& tissue = properties.tissue;
  std::string text = format("mu %.1f Pa, nu %.3f, gland x %.2f", tissue.shear_modulus,
                            tissue.poisson_ratio, tissue.gland_ratio);
  if (tissue.skin_stiffness > 0.)
    text += format(", skin %.0f Pa mm", tissue.skin_stiffness);
  if (properties.chest_stiffness > 0.)
    text += format(", chest %.2f Pa/mm", properties.chest_stiffness);
  if (properties.chest_stiffness > 0. && properties.lateral_chest_ratio != 1.)
    text += format(" (x %.2f at the side)", properties.lateral_chest_ratio);
  if (properties.cut_plane_stiffness.prone > 0.)
    text += format(", cuts %.1f and %.1f Pa/mm", properties.cut_plane_stiffness.prone,
                   properties.cut_plane_stiffness.supine);
  const auto [left, superior] = properties.tilt.degrees();
  if (has_.can_tilt)
    text += format(", supine gravity tilted %.1f left, %.1f up", left, superior);
  return text;
}

void PropertyTrials::report(double value) const {
  log_.line(format("  level %g mm: ", comparison_.level()) + in_words(pair_.properties()) +
            format("; %s %.4g", comparison_.name().c_str(), value));
  if (observer_)
    observer_({"material", comparison_.level(), progress_.n_accepted, 0., value});
}

} // namespace prosup::registration
