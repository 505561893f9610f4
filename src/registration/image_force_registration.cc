#include "prosup/registration/image_force_registration.h"

#include <algorithm>
#include <utility>

#include "gauss_newton.h"
#include "prosup/core/error.h"

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
class ImageForceRegistration::Level {
public:
  Level(const ImageForceRegistration& parameters, BodyPair& pair, const SimilaritySetup& setup,
        similarity::SimilarityDomain domain, double level, const Log& log)
      : parameters_(parameters), pair_(pair), setup_(setup), domain_(std::move(domain)),
        level_(level), log_(log), images_(setup.images(pair, level)) {}

  /// Updates until nothing more is gained; returns the weight at the end.
  double run(double weight, ImageForceResult& result) {
    SimilarityResult current = evaluate();
    record(result, 0, 0., current.value);
    unsigned n_rejected = 0, n_idle = 0;
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
      record(result, i++, weight, next.value);
      ++result.n_updates;
      n_idle =
          current.value - next.value < parameters_.least_gain_ * current.value ? n_idle + 1 : 0;
      current = std::move(next);
      if (n_idle >= patience)
        break;
      weight *= weight_growth;
    }
    return weight;
  }

private:
  SimilarityResult evaluate() const {
    return setup_.force().evaluate(domain_, pair_.loaded_states(images_));
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

  void record(ImageForceResult& result, unsigned iteration, double weight, double value) const {
    result.history.push_back({"image_forces", level_, iteration, 0., weight, value});
    log_.progress(format("  image forces: level %g mm, update %u, weight %.1f Pa, SSD %.1f", level_,
                         iteration, weight, value));
  }

  const ImageForceRegistration& parameters_;
  BodyPair& pair_;
  const SimilaritySetup& setup_;
  const similarity::SimilarityDomain domain_;
  const double level_;
  const Log& log_;
  const std::array<image::ScalarImage, 2> images_;
  std::array<mechanics::NodeVector, 2> increments_; // the last ones
};

ImageForceRegistration::ImageForceRegistration() : ParameterAcceptor("Image forces") {}

void ImageForceRegistration::declare_parameters(ParameterHandler& prm) {
  prm.add_parameter("Levels", levels_,
                    "Edges of the voxels of the similarity grid, from coarse to fine. Units: mm.",
                    Patterns::List(Patterns::Double(0.1, 50.), 0, 20));
  prm.add_parameter("Updates per level", updates_per_level_,
                    "Largest number of accepted force updates on a level. Units: none.",
                    Patterns::Integer(0, 10000));
  prm.add_parameter("Steps per update", steps_per_update_,
                    "Time steps of the simulation after each force update. Units: none.",
                    Patterns::Integer(1, 100000));
  prm.add_parameter(
      "Ramp fraction", ramp_fraction_,
      "Part of these steps over which a new force rises to its value, s(t) of eq. 15. "
      "Units: none.",
      Patterns::Double(0., 1.));
  prm.add_parameter(
      "Weight", weight_,
      "First weight kappa of the image forces over the shear modulus; adapts from there. "
      "Units: none (images are scaled to [0, 1]).",
      Patterns::Double(1e-9, 1e6));
  prm.add_parameter("Momentum", momentum_,
                    "Part of the last increment of the force that the next one keeps, so that soft "
                    "directions, in which the residual hardly changes, go faster. Units: none.",
                    Patterns::Double(0., 0.99));
  prm.add_parameter(
      "Smallest Jacobian", smallest_jacobian_,
      "An update that brings any element below this J = det F is taken back. Units: none.",
      Patterns::Double(0., 1.));
  prm.add_parameter(
      "Least gain", least_gain_,
      "A level ends after three updates in a row that lower the similarity by less than "
      "this part. Units: none.",
      Patterns::Double(0., 1.));
}

ImageForceResult ImageForceRegistration::run(BodyPair& pair, const SimilaritySetup& setup,
                                             const similarity::Scene& scene, double shear_modulus,
                                             const Log& log) const {
  ImageForceResult result;
  if (getenv("GN")) {
    GaussNewtonParameters parameters;
    parameters.weight = weight_;
    parameters.max_updates = updates_per_level_;
    parameters.least_gain = least_gain_;
    if (getenv("FREE")) parameters.free_anchor = true;
    if (getenv("TOL")) parameters.tolerance = atof(getenv("TOL"));
    GaussNewton gn(parameters, pair, setup, log);
    for (const double level : levels_)
      gn.run_level(scene, level, shear_modulus, result.history);
    gn.finish();
    const auto settled = pair.unload();
    result.n_steps += settled[prone].n_steps + settled[supine].n_steps;
    result.converged = settled[prone].converged && settled[supine].converged;
    log.line(format("settle: %u %u steps", settled[prone].n_steps, settled[supine].n_steps));
    return result;
  }
  double weight = weight_ * shear_modulus;
  for (const double level : levels_) {
    weight =
        Level(*this, pair, setup, setup.domain(pair, scene, level), level, log).run(weight, result);
    log.line(format("  image forces: level %g mm, SSD %.1f after %u updates", level,
                    result.history.back().value, result.history.back().iteration));
  }
  const auto settled = pair.unload();
  result.n_steps += settled[prone].n_steps + settled[supine].n_steps;
  result.converged = settled[prone].converged && settled[supine].converged;
  return result;
}

} // namespace prosup::registration
