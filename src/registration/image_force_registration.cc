#include "prosup/registration/image_force_registration.h"

#include "descent_scheme.h"
#include "prosup/core/error.h"
#include "prosup/core/parameters.h"
#include "prosup/registration/simulated_bodies.h"

namespace prosup::registration {

using namespace dealii;
using similarity::prone;
using similarity::supine;

namespace {

constexpr const char* accumulated = "accumulated";

std::vector<std::string> scheme_names() {
  std::vector<std::string> names = descent_scheme_names();
  names.emplace_back(accumulated);
  return names;
}

const std::vector<std::string> force_names{"exact", "transformed"};

} // namespace

ImageForceRegistration::ImageForceRegistration()
    : ParameterAcceptor("Image forces"), scheme_(scheme_names().front()),
      force_(force_names.front()) {}

void ImageForceRegistration::declare_parameters(ParameterHandler& prm) {
  prm.add_parameter("Scheme", scheme_,
                    "gauss-newton: steps with the stiffness of body and images. l-bfgs, "
                    "steepest-descent: with that of the body alone, as starting point or "
                    "throughout. accumulated: the paper's, forces added up in the running "
                    "simulation (eq. 15).",
                    one_of(scheme_names()));
  prm.add_parameter("Levels", levels_,
                    "Edges of the voxels of the similarity grid, from coarse to fine. Units: mm.",
                    Patterns::List(Patterns::Double(0.1, 50.), 0, 20));
  prm.add_parameter("Updates per level", updates_per_level_,
                    "Largest number of accepted updates on a level. Units: none.",
                    Patterns::Integer(0, 10000));
  prm.add_parameter(
      "Image weight", image_weight_,
      "All but accumulated: w in kappa = w mu/sigma^2, the weight of the images against the "
      "elasticity of the body; sigma^2 is the variance of their residual. Units: none.",
      Patterns::Double(1e-9, 1e6));
  prm.add_parameter(
      "Smallest Jacobian", smallest_jacobian_,
      "An update that brings any element below this J = det F is taken back. Units: none.",
      Patterns::Double(0., 1.));
  prm.add_parameter(
      "Least gain", least_gain_,
      "All but accumulated: a level ends with an update that lowers what is minimised by less "
      "than this part of all that was gained on it. Units: none.",
      Patterns::Double(0., 1.));
  prm.add_parameter("Force", force_,
                    "accumulated: the exact derivative by the displacement, with the gradient of "
                    "the loaded image, or the paper's transformed one, F f with that of the "
                    "unloaded image.",
                    one_of(force_names));
  prm.add_parameter("Time per update", time_per_update_,
                    "accumulated: time that is simulated after each update, times the damping rate "
                    "r/rho. Units: none.",
                    Patterns::Double(1e-3, 1e4));
  prm.add_parameter("Ramp fraction", ramp_fraction_,
                    "accumulated: part of this time over which a new force rises to its value, "
                    "s(t) of eq. 15. Units: none.",
                    Patterns::Double(0., 1.));
  prm.add_parameter(
      "First weight", first_weight_,
      "accumulated: first weight kappa over the shear modulus; adapts from there. Units: none "
      "(images are scaled to [0, 1]).",
      Patterns::Double(1e-9, 1e6));
  prm.add_parameter("Momentum", momentum_,
                    "accumulated: part of the last increment of the force that the next one keeps, "
                    "so that soft directions, in which the residual hardly changes, go faster. "
                    "Units: none.",
                    Patterns::Double(0., 0.99));
  prm.add_parameter("Least fall", least_fall_,
                    "accumulated: a level ends after three updates in a row that lower the "
                    "similarity by less than this part. Units: none.",
                    Patterns::Double(0., 1.));
}

ImageForceResult ImageForceRegistration::run(BodyPair& pair, const SimilaritySetup& setup,
                                             const similarity::Scene& scene,
                                             const mechanics::TissueMaterial& material,
                                             const Log& log, const Observer& observer) const {
  if (scheme_ == accumulated) {
    SimulatedBodies bodies(pair, setup, scene, material);
    return accumulate(bodies, log, observer);
  }
  ImageForceResult result;
  run_descent(pair, setup, scene, log, observer, result);
  settle([&] { return pair.unload(); }, log, result);
  return result;
}

void ImageForceRegistration::settle(const Settle& unload, const Log& log,
                                    ImageForceResult& result) {
  try {
    const auto settled = unload();
    result.n_steps += settled[prone].n_steps + settled[supine].n_steps;
    result.converged = settled[prone].converged && settled[supine].converged;
  } catch (const DivergenceError& error) { // which has restored the last good state
    log.line(std::string("  ") + error.what());
    result.converged = false;
  }
}

} // namespace prosup::registration
