#ifndef PROSUP_REGISTRATION_MATERIAL_UPDATE_H
#define PROSUP_REGISTRATION_MATERIAL_UPDATE_H

#include <deal.II/base/parameter_acceptor.h>

#include <vector>

#include "prosup/core/log.h"
#include "prosup/mechanics/material.h"
#include "prosup/registration/body_pair.h"
#include "prosup/registration/similarity_setup.h"

namespace prosup::registration {

struct MaterialUpdateResult {
  double shear_modulus = 0.; ///< accepted, Pa
  unsigned n_steps = 0;      ///< time steps of all trials
  bool converged = true;     ///< of the accepted state
  std::vector<SimilarityRecord> history;
};

/// The paper's material optimisation: multiplies the shear modulus (and with
/// it lambda) by a constant factor, stiffer or softer, unloads both states
/// again from where they are, and goes on while the similarity improves; the
/// last, unsuccessful trial is discarded. Section "Material update".
class MaterialUpdate : public dealii::ParameterAcceptor {
public:
  MaterialUpdate();
  void declare_parameters(dealii::ParameterHandler& prm) override;

  /// The pair has to be unloaded with `shear_modulus` (Pa); is left unloaded
  /// with the accepted one.
  MaterialUpdateResult run(BodyPair& pair, const SimilaritySetup& setup,
                           const similarity::SimilarityDomain& domain,
                           const mechanics::TissueMaterial& material, double shear_modulus,
                           const Log& log) const;

  /// Voxel edge of the grid on which the images are compared, mm.
  double level() const { return level_; }

private:
  double factor_ = 1.1;
  unsigned max_steps_ = 20;
  double level_ = 4.;
};

} // namespace prosup::registration

#endif
