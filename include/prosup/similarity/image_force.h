#ifndef PROSUP_SIMILARITY_IMAGE_FORCE_H
#define PROSUP_SIMILARITY_IMAGE_FORCE_H

#include <memory>
#include <vector>

#include "prosup/similarity/element_samples.h"

namespace prosup::similarity {

/// The dissimilarity of two imaged bodies and its forces.
struct SimilarityResult {
  double value = 0.;             ///< S, mm^3
  double residual_variance = 0.; ///< as Dissimilarity::residual_variance
  /// -dS/du_a or -dS/dX_a of each body that this rank holds, owned nodes, [S]/mm: mm^2 for the SSD
  /// of images scaled to [0, 1]. Empty for other bodies.
  PerPosition<mechanics::NodeVector> forces;
  /// As ElementSamples::stiffness(); only if asked for.
  PerPosition<std::vector<mechanics::CellStiffness>> stiffness;
};

/// Symmetric image forces of two bodies of finite elements, eq. 12 to 14: warps both images to the
/// common unloaded grid and projects the forces of the voxels to the nodes,
///   f_a = -sum_v dS/dP_v grad_x P_loaded(x(X_v)) N_a(X_v),
/// the exact derivative of the discrete value by the displacement u_a at fixed X, since
/// P(X) = P_loaded(X + u). The paper's F f in eq. 15 approximates it: grad_x = F^-T grad_X.
/// Collective on `communicator`, which holds the ranks of both positions.
class ImageForce {
public:
  ImageForce(std::shared_ptr<const Metric> metric, MPI_Comm communicator);

  /// The value, the forces on the nodes by `variable`, and the stiffness of the images if wanted.
  SimilarityResult evaluate(const SimilarityDomain& domain, const PerPosition<ImagedBody>& bodies,
                            Variable variable = Variable::displacement,
                            bool with_stiffness = false) const;

  /// The value alone.
  double value(const SimilarityDomain& domain, const PerPosition<ImagedBody>& bodies) const;

  /// As residuals_of(), on every rank.
  std::vector<float> residuals(const SimilarityDomain& domain,
                               const PerPosition<ImagedBody>& bodies) const;

  /// The two warped images, on every rank, for pictures and other measures.
  WarpedPair warp(const SimilarityDomain& domain, const PerPosition<ImagedBody>& bodies) const;

private:
  std::shared_ptr<const Metric> metric_;
  MPI_Comm communicator_;
};

} // namespace prosup::similarity

#endif
