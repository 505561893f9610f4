#ifndef PROSUP_REGISTRATION_IMAGE_FORCE_REGISTRATION_H
#define PROSUP_REGISTRATION_IMAGE_FORCE_REGISTRATION_H

#include <deal.II/base/parameter_acceptor.h>

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "prosup/core/log.h"
#include "prosup/registration/body_pair.h"
#include "prosup/registration/similarity_setup.h"

namespace prosup::registration {

struct ImageForceResult {
  unsigned n_steps = 0;   ///< time steps of both states
  unsigned n_updates = 0; ///< accepted ones
  bool converged = true;  ///< both states settled under the final forces
};

/// Pushes the unloaded breasts together with image forces, from coarse to fine
/// image levels. Section "Image forces".
///
/// gauss-newton, l-bfgs and steepest-descent minimise, in the unloaded positions X of
/// both states,
///   phi(X) = kappa S(X) + 1/2 sum_states (X - X0)^T K (X - X0),
/// S being the similarity, X0 the positions without image forces and K the
/// stiffness of the body at X0. With the image's own stiffness H (Gauss-Newton, see
/// SimilarityResult::stiffness) an update solves for each state
///   (K + 2 kappa H) dX = -kappa dS/dX - K (X - X0).
/// The two is that of the other state, which moves against this one: were both
/// images and bodies the same, the two equations would be the Newton step of
/// both together. Steepest descent has K alone on the left, the metric of the body;
/// L-BFGS starts from that. A step that does not lower phi or brings an element near
/// inversion is halved. kappa = w mu/sigma^2 with the variance of the residual
/// sigma^2 (SimilarityResult::residual_variance) as it is at present, so that one
/// weight w serves all contrasts, and images count more the better they fit. The
/// nodal forces that hold X are those of the state, Unloading::adopt().
///
/// accumulated: the paper's eq. 15. At each update the force of the present
/// residual is added to all earlier ones with the weight kappa, rising from 0 to
/// its value over the first part of the following time steps (the polygonal
/// s(t)): gradient descent in the metric of the body. kappa adapts: an update
/// that makes the images less alike, or brings an element near inversion, is
/// taken back and repeated with half the weight; one that succeeds raises it.
class ImageForceRegistration : public dealii::ParameterAcceptor {
public:
  ImageForceRegistration();
  void declare_parameters(dealii::ParameterHandler& prm) override;

  /// Pushes the bodies of `pair` by the chosen scheme. The pair has to be unloaded with its
  /// properties. If it does not settle under the final forces it keeps its last good
  /// state, and `log` says why.
  ImageForceResult run(BodyPair& pair, const SimilaritySetup& setup, const similarity::Scene& scene,
                       const mechanics::TissueMaterial& material, const Log& log,
                       const Observer& observer = {}) const;

  /// Pushes any pair by the scheme `accumulated`, whatever was chosen.
  ImageForceResult accumulate(SimulatedPair& pair, const Log& log,
                              const Observer& observer = {}) const;

private:
  class Accumulation;
  class Descent;

  void run_descent(BodyPair& pair, const SimilaritySetup& setup, const similarity::Scene& scene,
                   const Log& log, const Observer& observer, ImageForceResult& result) const;

  /// Unloads until all is at rest.
  using Settle = std::function<std::array<settling::SettlingResult, 2>()>;
  static void settle(const Settle& unload, const Log& log, ImageForceResult& result);

  std::string scheme_;
  std::vector<double> levels_{4., 2., 1.};
  unsigned updates_per_level_ = 20;
  double image_weight_ = 0.1;
  double smallest_jacobian_ = 0.2;
  double least_gain_ = 0.02;
  // accumulated
  std::string force_;
  double time_per_update_ = 15.;
  double ramp_fraction_ = 0.5;
  double first_weight_ = 0.1;
  double momentum_ = 0.5;
  double least_fall_ = 0.005;
};

} // namespace prosup::registration

#endif
