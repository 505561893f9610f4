#include "prosup/registration/simulated_bodies.h"

#include <utility>

namespace prosup::registration {

using settling::SettlingResult;

std::array<SettlingResult, 2> SimulatedBodies::unload(unsigned max_steps) {
  return pair_.unload(max_steps);
}

std::array<SettlingResult, 2> SimulatedBodies::advance(double duration) {
  std::array<SettlingResult, 2> results;
  pair_.for_each([&](State which, BodyState& state) {
    results[which] = state.unloading->advance(steps_within(duration, *state.unloading));
  });
  return pair_.ranks().share(results);
}

void SimulatedBodies::compare_on(double level, Compared compared) {
  comparison_.emplace(compared == Compared::images ? setup_.of_images(pair_, scene_, level)
                                                   : setup_.of_tissues(pair_, scene_, level));
}

double SimulatedBodies::value() const {
  return comparison_->force.value(comparison_->domain, pair_.loaded_states(comparison_->images));
}

std::vector<float> SimulatedBodies::residuals() const {
  return comparison_->force.residuals(comparison_->domain,
                                      pair_.loaded_states(comparison_->images));
}

double SimulatedBodies::find_forces(similarity::Variable variable) {
  similarity::SimilarityResult result = comparison_->force.evaluate(
      comparison_->domain, pair_.loaded_states(comparison_->images), variable);
  forces_ = std::move(result.forces);
  return result.value;
}

void SimulatedBodies::add_forces(double weight, double momentum, double ramp) {
  pair_.for_each([&](State which, BodyState& state) {
    mechanics::NodeVector& increment = increments_[which];
    if (increment.size() == 0)
      state.body->initialize(increment);
    increment.sadd(momentum, weight, forces_[which]);
    state.unloading->add_force(increment, ramp / state.unloading->damping_rate());
  });
}

} // namespace prosup::registration
