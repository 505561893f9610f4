#include <algorithm>
#include <utility>

#include "prosup/core/error.h"
#include "prosup/registration/image_force_registration.h"

namespace prosup::registration {

using namespace dealii;
using similarity::prone;
using similarity::SimilarityResult;
using similarity::supine;

namespace {

constexpr double weight_growth = 1.2;
constexpr unsigned max_rejections = 5; // in a row, before a level is given up
constexpr unsigned patience = 3;       // updates in a row with hardly any gain

} // namespace

/// The updates on one image level.
class ImageForceRegistration::Accumulation {
public:
  Accumulation(const ImageForceRegistration& parameters, BodyPair& pair,
               const SimilaritySetup& setup, similarity::SimilarityDomain domain, double level,
               const Log& log, const Observer& observer)
      : parameters_(parameters), pair_(pair), setup_(setup), domain_(std::move(domain)),
        variable_(parameters.force_ == "transformed"
                      ? similarity::Variable::transformed_displacement
                      : similarity::Variable::displacement),
        level_(level), log_(log), observer_(observer), images_(setup.images(pair, level)) {}

  /// Updates until nothing more is gained; returns the weight at the end.
  double run(double weight, ImageForceResult& result) {
    SimilarityResult current = evaluate();
    record(0, 0., current.value);
    unsigned n_rejected = 0, n_idle = 0;
    const unsigned n_before = result.n_updates;
    for (unsigned i = 1; i <= parameters_.updates_per_level_;) {
      const BodyPair::Snapshot before = pair_.save();
      SimilarityResult next;
      if (!push(current, weight, result) || !((next = evaluate()).value < current.value)) {
        pair_.restore(before);
        increments_ = {};
        weight *= 0.5;
        if (++n_rejected > max_rejections)
          break;
        // The state may have been on its way past where its forces hold it.
        relax(result);
        current = evaluate();
        continue;
      }
      n_rejected = 0;
      record(i++, weight, next.value);
      ++result.n_updates;
      n_idle =
          current.value - next.value < parameters_.least_fall_ * current.value ? n_idle + 1 : 0;
      current = std::move(next);
      if (n_idle >= patience)
        break;
      weight *= weight_growth;
    }
    log_.line(format("  level %g mm: %s %.4g after %u updates", level_, setup_.metric().c_str(),
                     current.value, result.n_updates - n_before));
    return weight;
  }

private:
  SimilarityResult evaluate() const {
    return setup_.force().evaluate(domain_, pair_.loaded_states(images_), variable_);
  }

  /// Adds the weighted forces and simulates; false if an element came near
  /// inversion.
  bool push(const SimilarityResult& similarity, double weight, ImageForceResult& result) {
    const double momentum = parameters_.momentum_;
    try {
      pair_.for_each([&](State which, BodyState& state) {
        mechanics::NodeVector& increment = increments_[which];
        if (increment.size() == 0)
          state.body->initialize(increment);
        increment.sadd(momentum, weight, similarity.forces[which]);
        state.unloading->add_force(increment, parameters_.ramp_fraction_ *
                                                  parameters_.steps_per_update_ *
                                                  state.unloading->time_step());
      });
      const auto unloaded = pair_.unload(parameters_.steps_per_update_);
      result.n_steps += unloaded[prone].n_steps + unloaded[supine].n_steps;
      return std::min(unloaded[prone].min_jacobian, unloaded[supine].min_jacobian) >
                 parameters_.smallest_jacobian_ &&
             unloaded[prone].n_retries + unloaded[supine].n_retries == 0;
    } catch (const Error&) {
      return false;
    }
  }

  void relax(ImageForceResult& result) {
    const auto unloaded = pair_.unload(parameters_.steps_per_update_);
    result.n_steps += unloaded[prone].n_steps + unloaded[supine].n_steps;
  }

  void record(unsigned iteration, double weight, double value) const {
    log_.progress(format("  image forces: level %g mm, update %u, weight %.1f Pa, %s %.4g", level_,
                         iteration, weight, setup_.metric().c_str(), value));
    if (observer_)
      observer_({"image_forces", level_, iteration, weight, value});
  }

  const ImageForceRegistration& parameters_;
  BodyPair& pair_;
  const SimilaritySetup& setup_;
  const similarity::SimilarityDomain domain_;
  const similarity::Variable variable_;
  const double level_;
  const Log& log_;
  const Observer& observer_;
  const std::array<image::ScalarImage, 2> images_;
  std::array<mechanics::NodeVector, 2> increments_; // the last ones
};

void ImageForceRegistration::run_accumulated(BodyPair& pair, const SimilaritySetup& setup,
                                             const similarity::Scene& scene, const Log& log,
                                             const Observer& observer,
                                             ImageForceResult& result) const {
  double weight = first_weight_ * pair.properties().tissue.shear_modulus;
  for (const double level : levels_)
    weight =
        Accumulation(*this, pair, setup, setup.domain(pair, scene, level), level, log, observer)
            .run(weight, result);
}

} // namespace prosup::registration
