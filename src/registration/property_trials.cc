#include "property_trials.h"

#include <utility>

#include "prosup/core/error.h"

namespace prosup::registration {

namespace {

/// What has not settled by then, several times the steps of a first unloading, hardly
/// will, and no step of the search is worth the time.
constexpr unsigned max_trial_steps = 3000;

/// Stops unloadings there while it lives.
class LimitedSteps {
public:
  explicit LimitedSteps(BodyPair& pair) : pair_(pair) {
    set([](unsigned n_steps) { return n_steps < max_trial_steps; });
  }
  ~LimitedSteps() { set(nullptr); }
  LimitedSteps(const LimitedSteps&) = delete;
  LimitedSteps& operator=(const LimitedSteps&) = delete;

private:
  void set(const unloading::Unloading::Observer& observer) {
    for (const State state : {similarity::prone, similarity::supine})
      if (pair_.ranks().holds(state))
        pair_[state].unloading->set_observer(observer);
  }

  BodyPair& pair_;
};

} // namespace

PropertyTrials::PropertyTrials(BodyPair& pair, Comparison comparison,
                               const mechanics::TissueMaterial& material, double level,
                               const Log& log, const Observer& observer,
                               MaterialUpdateResult& result)
    : pair_(pair), comparison_(std::move(comparison)), material_(material), level_(level),
      log_(log), observer_(observer), result_(result), best_value_(value()),
      best_properties_(pair.properties()), best_(pair.save()) {
  report(best_value_);
}

bool PropertyTrials::unload(const MechanicalProperties& properties) {
  ++result_.n_trials;
  const LimitedSteps limit(pair_);
  try {
    pair_.set_properties(material_, properties);
    const auto unloaded = pair_.unload();
    result_.n_steps += unloaded[0].n_steps + unloaded[1].n_steps;
    converged_ = unloaded[0].converged && unloaded[1].converged;
    return unloaded[0].n_steps < max_trial_steps && unloaded[1].n_steps < max_trial_steps;
  } catch (const Error& error) {
    log_.line(std::string("  trial rejected: ") + error.what());
    return false;
  }
}

double PropertyTrials::value() const {
  return comparison_.force.value(comparison_.domain, pair_.loaded_states(comparison_.images));
}

std::vector<float> PropertyTrials::residuals() const {
  return comparison_.force.residuals(comparison_.domain, pair_.loaded_states(comparison_.images));
}

void PropertyTrials::accept(double value) {
  best_value_ = value;
  best_properties_ = pair_.properties();
  best_ = pair_.save();
  result_.converged = converged_;
  ++n_accepted_;
  report(value);
}

void PropertyTrials::return_to_best() {
  pair_.set_properties(material_, best_properties_);
  pair_.restore(best_);
}

void PropertyTrials::report(double value) const {
  const mechanics::TissueStiffness& tissue = pair_.properties().tissue;
  std::string text = format("  level %g mm: mu %.1f Pa, nu %.3f, gland x %.2f", level_,
                            tissue.shear_modulus, tissue.poisson_ratio, tissue.gland_ratio);
  if (pair_.properties().chest_stiffness > 0.)
    text += format(", chest %.2f Pa/mm", pair_.properties().chest_stiffness);
  log_.line(text + format("; %s %.4g", comparison_.metric.c_str(), value));
  if (observer_)
    observer_({"material", level_, n_accepted_, 0., value});
}

} // namespace prosup::registration
