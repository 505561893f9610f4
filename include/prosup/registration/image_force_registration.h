#ifndef PROSUP_REGISTRATION_IMAGE_FORCE_REGISTRATION_H
#define PROSUP_REGISTRATION_IMAGE_FORCE_REGISTRATION_H

#include <deal.II/base/parameter_acceptor.h>

#include <array>
#include <vector>

#include "prosup/core/log.h"
#include "prosup/registration/body_pair.h"
#include "prosup/registration/similarity_setup.h"

namespace prosup::registration {

struct ImageForceResult {
  unsigned n_steps = 0;   ///< time steps of both states
  unsigned n_updates = 0; ///< accepted force updates
  bool converged = true;  ///< both states settled under the final forces
  std::vector<SimilarityRecord> history;
};

/// Accumulates image forces in the running unloading simulations, eq. 15: at
/// each update the force of the present residual is added to all earlier ones
/// with the weight kappa, rising from 0 to its value over the first part of
/// the following time steps (the polygonal s(t)). kappa adapts: an update that
/// makes the images less alike, or brings an element near inversion, is taken
/// back and repeated with half the weight; one that succeeds raises it. From
/// coarse to fine image levels. Section "Image forces".
class ImageForceRegistration : public dealii::ParameterAcceptor {
public:
  ImageForceRegistration();
  void declare_parameters(dealii::ParameterHandler& prm) override;

  /// The pair has to be unloaded; `shear_modulus` (Pa) scales the weight.
  ImageForceResult run(BodyPair& pair, const SimilaritySetup& setup, const similarity::Scene& scene,
                       double shear_modulus, const Log& log) const;

private:
  class Level;

  std::vector<double> levels_{4., 2.};
  unsigned updates_per_level_ = 20;
  unsigned steps_per_update_ = 150;
  double ramp_fraction_ = 0.5;
  double weight_ = 0.1;
  double momentum_ = 0.5;
  double smallest_jacobian_ = 0.2;
  double least_gain_ = 0.005;
};

} // namespace prosup::registration

#endif
