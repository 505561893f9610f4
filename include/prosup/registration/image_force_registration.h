#ifndef PROSUP_REGISTRATION_IMAGE_FORCE_REGISTRATION_H
#define PROSUP_REGISTRATION_IMAGE_FORCE_REGISTRATION_H

#include <deal.II/base/parameter_acceptor.h>

#include <string>
#include <vector>

#include "prosup/core/log.h"
#include "prosup/mechanics/body/body.h"
#include "prosup/registration/comparison.h"

namespace prosup::registration {

/// What the image forces took, and how they ended.
struct ImageForceResult {
  unsigned n_steps = 0;   ///< time steps of both breasts
  unsigned n_updates = 0; ///< accepted ones
  bool converged = true;  ///< both breasts settled under the final forces
};

/// How far an ImageForceRegistration has come: it goes on from there with the pair as it is at such
/// a point.
struct ImageForceProgress {
  ImageForceResult result;
  unsigned level = 0;                       ///< index of the level at work
  image::VoxelGrid grid;                    ///< of its comparison; without voxels before it begins
  unsigned n_updates = 0;                   ///< on the level
  double gained = 0.;                       ///< on the level, parts of phi
  double length = 1.;                       ///< of the last step, in its direction
  double weight = 0.;                       ///< kappa of accumulated forces, Pa
  PerPosition<mechanics::NodeVector> start; ///< X0; of no size before the descent begins
  /// X of the last update, before sliding nodes are put on their surfaces, which moves them a
  /// little each time it is done.
  PerPosition<mechanics::NodeVector> present;
};

/// Pushes the unloaded breasts together with image forces, from coarse to fine image levels,
/// section "Image forces".
///
/// gauss-newton, l-bfgs and steepest-descent minimise, in the unloaded positions X of both breasts,
///   phi(X) = kappa S(X) + 1/2 sum_breasts (X - X0)^T K (X - X0),
/// with the dissimilarity S, the positions X0 without image forces and the stiffness K of the
/// breast at X0. With the stiffness H of the image (Gauss-Newton, SimilarityResult::stiffness) an
/// update solves for each breast
///   (K + 2 kappa H) dX = -kappa dS/dX - K (X - X0).
/// Each breast is solved for alone, as if the other one moved by the same amount in the opposite
/// direction. This doubles the change of the residual and gives the factor 2; for two equal breasts
/// the step is then Newton's for both together. Steepest descent has K alone on the left; L-BFGS
/// starts from K. A step that does not lower phi, or brings an element near inversion, is halved.
/// kappa = w mu/sigma^2 with the present variance sigma^2 of the residual
/// (SimilarityResult::residual_variance), so that one weight w serves all contrasts, and images
/// count more the better they agree. The nodal forces that hold X are found by
/// Unloading::adopt(). For breasts of finite elements only.
///
/// accumulated: the paper's eq. 15, for breasts of all methods. Each update adds the force of the
/// present residual to all earlier ones, with the weight kappa. The added force rises from 0 to its
/// value over the first part of the following time steps (the polygonal s(t)). This is gradient
/// descent in the metric of the breast. kappa adapts: an update that makes the images less alike,
/// or brings an element near inversion, is taken back and repeated with half the weight; one that
/// succeeds raises it.
class ImageForceRegistration : public dealii::ParameterAcceptor {
public:
  ImageForceRegistration();
  void declare_parameters(dealii::ParameterHandler& prm) override;

  /// Pushes the breasts of `pair`, which has to be unloaded with its properties, by the chosen
  /// scheme; by `accumulated` if they do not consist of finite elements. If they do not settle
  /// under the final forces they keep their last good state, and `log` says why.
  ImageForceResult run(BreastPair& pair, const ComparedImages& images, const Log& log,
                       const Observer& observer = {}) const;
  /// The same from `progress` on, which it brings up to date; `keep` is called where both it and
  /// the pair could be kept to go on from.
  void run(BreastPair& pair, const ComparedImages& images, const Log& log, const Observer& observer,
           ImageForceProgress& progress, const Keeper& keep) const;

private:
  class Accumulation;
  class Descent;

  void accumulate(BreastPair& pair, const ComparedImages& images, const Log& log,
                  const Observer& observer, ImageForceProgress& progress, const Keeper& keep) const;
  void descend(BreastPair& pair, const ComparedImages& images, const Log& log,
               const Observer& observer, ImageForceProgress& progress, const Keeper& keep) const;
  static void settle(BreastPair& pair, const Log& log, ImageForceResult& result);

  std::string scheme_;
  std::vector<double> levels_{4., 2., 1.};
  unsigned updates_per_level_ = 20;
  double weight_ = 0.1;
  double model_error_ = 1.;
  double smallest_jacobian_ = 0.2;
  double largest_jacobian_ = 2.;
  double least_gain_ = 0.02;
  struct {
    std::string force_gradient;
    double time_per_update = 15.;
    double ramp_fraction = 0.5;
    double first_weight = 0.1;
    double momentum = 0.5;
    double least_gain = 0.005;
  } accumulated_;
};

} // namespace prosup::registration

#endif
