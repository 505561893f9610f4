#ifndef PROSUP_REGISTRATION_UNCERTAINTY_H
#define PROSUP_REGISTRATION_UNCERTAINTY_H

#include <deal.II/base/parameter_acceptor.h>
#include <deal.II/base/symmetric_tensor.h>

#include <vector>

#include "prosup/mechanics/body/body.h"
#include "prosup/registration/comparison.h"

namespace prosup::registration {

/// How sure the unloaded positions of a registration are, section "Uncertainty". For breasts of
/// finite elements. At each node
///   C = theta (K + 2 kappa H)^-1
///       + 1/3 [c D^2 exp(-2 d_c/l) + e max(D^2 - D0^2, 0) exp(-2 d_w/m)] I
/// is the covariance of the distance between the unloaded positions that the two images give the
/// same tissue. K is the stiffness of the unloaded breast whose supports give way, H that of the
/// images, kappa = w mu/sigma^2. The first term is the posterior of the image forces. D, the
/// distance by which the image forces had to move the breasts, tells how wrong the model is: theta
/// grows with max(D^2 - D0^2, 0), beyond the motion D0 that is usual with a right model, and with
/// the volume of a voxel. The second term leaves an error where tissue is cut off, at the distance
/// d_c, and at the distance d_w from the chest wall, whose bed is what models get wrong.
/// docs/uncertainty.md tells where the constants come from.
class UncertaintyParameters : public dealii::ParameterAcceptor {
public:
  UncertaintyParameters();
  void declare_parameters(dealii::ParameterHandler& prm) override;

  bool wanted = true;

  /// Of the nodes of each breast, mm^2.
  using Covariances = PerPosition<std::vector<dealii::SymmetricTensor<2, 3>>>;

  /// The covariances of the nodes of both meshes, mm^2, on rank 0 of the pair, where the image
  /// forces started from the positions `start`; empty if they are not wanted or the breasts do not
  /// consist of finite elements. Leaves the pair as it is. Collective.
  Covariances covariances(const BreastPair& pair, const ComparedImages& images,
                          const PerPosition<mechanics::NodeVector>& start) const;

private:
  unsigned n_samples_ = 32;
};

} // namespace prosup::registration

#endif
