#include "prosup/registration/image_force_registration.h"

#include "descent_scheme.h"
#include "prosup/core/error.h"
#include "prosup/core/parameters.h"

namespace prosup::registration {

using namespace dealii;

namespace {

constexpr const char* accumulated = "accumulated";

std::vector<std::string> scheme_names() {
  std::vector<std::string> names = descent_scheme_names();
  names.emplace_back(accumulated);
  return names;
}

const std::vector<std::string> force_gradient_names{"exact", "transformed"};

} // namespace

ImageForceRegistration::ImageForceRegistration()
    : ParameterAcceptor("Image forces"), scheme_(scheme_names().front()) {
  accumulated_.force_gradient = force_gradient_names.front();
}

void ImageForceRegistration::declare_parameters(ParameterHandler& prm) {
  prm.add_parameter(
      "Scheme", scheme_,
      "How the breasts are pushed together. gauss-newton: steps with the stiffness of "
      "breast and images. l-bfgs: starts from the stiffness of the breast alone. "
      "steepest-descent: keeps to that. accumulated: the paper's, forces added up in "
      "the running simulation (eq. 15); fdm always uses it.",
      one_of(scheme_names()));
  prm.add_parameter("Levels", levels_,
                    "Edges of the voxels on which the images are compared, from coarse to fine. "
                    "Units: mm.",
                    Patterns::List(Patterns::Double(0.1, 50.), 0, 20));
  prm.add_parameter("Updates per level", updates_per_level_,
                    "Largest number of accepted updates on a level. Units: none.",
                    Patterns::Integer(0, 10000));
  prm.add_parameter("Weight", weight_,
                    "w in kappa = w mu/sigma^2, the weight of the images against the elasticity of "
                    "the breast; sigma^2 is the variance of the residual. Not for accumulated. "
                    "Units: none.",
                    Patterns::Double(1e-9, 1e6));
  prm.add_parameter("Model error", model_error_,
                    "Distance by which the images may move the nodes of a right model, root mean "
                    "square. In proportion as they move them by more, the weight grows, up to ten "
                    "times. 0: the weight stays. Not for accumulated. Units: mm.",
                    Patterns::Double(0., 1e3));
  prm.add_parameter("Smallest Jacobian", smallest_jacobian_,
                    "An update that brings any element below this J = det F is taken back. "
                    "Units: none.",
                    Patterns::Double(0., 1.));
  prm.add_parameter(
      "Largest Jacobian", largest_jacobian_,
      "Nodes whose step would bring an element above this J = det F, so that its "
      "unloaded shape gets flat, take a shorter one. Not for accumulated. Units: "
      "none. Default: no element of the sample cases exceeds 1.8 without image forces.",
      Patterns::Double(1., 1e6));
  prm.add_parameter("Least gain", least_gain_,
                    "A level ends with an update that gains less than this part of all that was "
                    "gained on the level. Not for accumulated. Units: none.",
                    Patterns::Double(0., 1.));
  prm.enter_subsection("Accumulated");
  prm.add_parameter("Force gradient", accumulated_.force_gradient,
                    "exact: the gradient of the loaded image, which gives the derivative by the "
                    "displacement. transformed: the paper's F f, with the gradient of the unloaded "
                    "image.",
                    one_of(force_gradient_names));
  prm.add_parameter("Time per update", accumulated_.time_per_update,
                    "Simulated time after each update, times the damping rate r/rho. Units: none.",
                    Patterns::Double(1e-3, 1e4));
  prm.add_parameter("Ramp fraction", accumulated_.ramp_fraction,
                    "Part of this time over which a new force rises to its value, s(t) of eq. 15. "
                    "Units: none.",
                    Patterns::Double(0., 1.));
  prm.add_parameter("First weight", accumulated_.first_weight,
                    "First weight kappa over the shear modulus; it adapts from there. Units: none "
                    "(images are scaled to [0, 1]).",
                    Patterns::Double(1e-9, 1e6));
  prm.add_parameter("Momentum", accumulated_.momentum,
                    "Part of the last increment of the force that is added again with the next, "
                    "which speeds up directions in which the residual hardly changes. Units: none.",
                    Patterns::Double(0., 0.99));
  prm.add_parameter(
      "Least gain", accumulated_.least_gain,
      "A level ends after three updates in a row that lower the dissimilarity by less "
      "than this part of it. Units: none.",
      Patterns::Double(0., 1.));
  prm.leave_subsection();
}

ImageForceResult ImageForceRegistration::run(BreastPair& pair, const ComparedImages& images,
                                             const Log& log, const Observer& observer) const {
  ImageForceProgress progress;
  run(pair, images, log, observer, progress, [] {});
  return progress.result;
}

void ImageForceRegistration::run(BreastPair& pair, const ComparedImages& images, const Log& log,
                                 const Observer& observer, ImageForceProgress& progress,
                                 const Keeper& keep) const {
  if (scheme_ == accumulated || !pair.consists_of_elements())
    accumulate(pair, images, log, observer, progress, keep);
  else
    descend(pair, images, log, observer, progress, keep);
  settle(pair, log, progress.result);
}

void ImageForceRegistration::settle(BreastPair& pair, const Log& log, ImageForceResult& result) {
  try {
    const auto settled = pair.unload();
    result.n_steps += settled.prone.n_steps + settled.supine.n_steps;
    result.converged = settled.prone.converged && settled.supine.converged;
  } catch (const Error& error) { // the breast that diverged has restored its last good state
    log.line(std::string("  ") + error.what());
    result.converged = false;
  }
}

} // namespace prosup::registration
