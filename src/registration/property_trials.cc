#include "property_trials.h"

#include <utility>

#include "prosup/core/error.h"

namespace prosup::registration {

namespace {

/// What has not settled by then, several times the steps of a first unloading, hardly
/// will, and no step of the search is worth the time.
constexpr unsigned max_trial_steps = 3000;

} // namespace

PropertyTrials::PropertyTrials(BreastPair& pair, Comparison comparison, const Log& log,
                               const Observer& observer, MaterialUpdateResult& result)
    : pair_(pair), comparison_(std::move(comparison)), log_(log), observer_(observer),
      result_(result), best_properties_(pair.properties()) {
  pair_.save();
  best_value_ = comparison_.value();
  report(best_value_);
}

bool PropertyTrials::unload(const MechanicalProperties& properties) {
  ++result_.n_trials;
  try {
    pair_.set_properties(properties);
    const auto unloaded = pair_.unload(max_trial_steps);
    result_.n_steps += unloaded.prone.n_steps + unloaded.supine.n_steps;
    converged_ = unloaded.prone.converged && unloaded.supine.converged;
    return unloaded.prone.n_steps < max_trial_steps && unloaded.supine.n_steps < max_trial_steps;
  } catch (const Error& error) {
    log_.line(std::string("  trial rejected: ") + error.what());
    return false;
  }
}

void PropertyTrials::accept(double value) {
  best_value_ = value;
  best_properties_ = pair_.properties();
  pair_.save();
  result_.converged = converged_;
  ++n_accepted_;
  report(value);
}

void PropertyTrials::return_to_best() {
  pair_.set_properties(best_properties_);
  pair_.restore();
}

void PropertyTrials::report(double value) const {
  const mechanics::TissueStiffness& tissue = pair_.properties().tissue;
  std::string text = format("  level %g mm: mu %.1f Pa, nu %.3f, gland x %.2f", comparison_.level(),
                            tissue.shear_modulus, tissue.poisson_ratio, tissue.gland_ratio);
  if (pair_.properties().chest_stiffness > 0.)
    text += format(", chest %.2f Pa/mm", pair_.properties().chest_stiffness);
  log_.line(text + format("; %s %.4g", comparison_.name().c_str(), value));
  if (observer_)
    observer_({"material", comparison_.level(), n_accepted_, 0., value});
}

} // namespace prosup::registration
