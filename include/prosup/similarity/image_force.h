#ifndef PROSUP_SIMILARITY_IMAGE_FORCE_H
#define PROSUP_SIMILARITY_IMAGE_FORCE_H

#include <array>
#include <memory>
#include <vector>

#include "prosup/image/voxel_image.h"
#include "prosup/mechanics/body/body.h"
#include "prosup/mechanics/static/elastic_metric.h"
#include "prosup/similarity/metric.h"

namespace prosup::similarity {

/// One state of the body as far as a rank holds it: null where another rank
/// works on it.
struct LoadedState {
  const mechanics::Body* body = nullptr;
  const mechanics::NodeVector* unloaded = nullptr; ///< X with ghosts, mm
  const image::ScalarImage* image = nullptr;       ///< in the loaded state
};

/// What is the same for all evaluations on one grid.
struct SimilarityDomain {
  image::VoxelGrid grid;
  /// Voxels in which an image without tissue there does not count as air: the
  /// chest, and all beyond the field of view.
  std::vector<bool> no_air;
  unsigned n_layers = 2;              ///< voxels added around each mesh
  std::array<float, 2> air{0.f, 0.f}; ///< intensity outside the body of either image
  /// Labels of the loaded states that are not 0 where no force is computed; either may
  /// be empty. Null: none. Have to live as long as the domain.
  const std::array<image::LabelImage, 2>* excluded = nullptr;
};

/// The nodal positions by which the value is derived while the others are held.
enum class Variable {
  displacement, ///< u at fixed X: dP(X_v) = grad_x P . N_a du_a
  /// The paper's F f of eq. 15, f having the gradient of the unloaded image
  /// grad_X P = F^T grad_x P: not the derivative by u but where F F^T = I.
  transformed_displacement,
  unloaded ///< X at fixed x: dP(X_v) = -(F^T grad_x P) . N_a dX_a, exact for linear cells
};

/// The dissimilarity of a pair and its forces.
struct SimilarityResult {
  double value = 0.;
  /// (sum_v slope_v^2)/(sum_v curvature_v)/h^3: the mean squared residual of the SSD, and
  /// what takes its place in other metrics. A change of the scale of S changes it
  /// alike.
  double residual_variance = 0.;
  /// -dS/du_a or -dS/dX_a of each state held by this rank, owned nodes, [S]/mm: for the
  /// SSD of images scaled to [0, 1], mm^2. Empty for other states.
  std::array<mechanics::NodeVector, 2> forces;
  /// The part of d^2S/du_a du_b that Gauss-Newton keeps,
  ///   sum_v d^2S/dP_v^2 N_a N_b grad_x P grad_x P^T
  /// (or by X, with F^T grad_x P),
  /// of each cell of this rank, [S]/mm^2: the stiffness of an image. Only if
  /// asked for.
  std::array<std::vector<mechanics::CellStiffness>, 2> stiffness;
};

/// Symmetric image forces, eq. 12 to 14: warps both images to the common
/// unloaded grid and projects the forces of the voxels to the nodes,
///   f_a = -sum_v dS/dP_v grad_x P_loaded(x(X_v)) N_a(X_v),
/// the exact derivative of the discrete value by the displacement u_a at fixed
/// X, since P(X) = P_loaded(X + u). The paper's F f in eq. 15 approximates it:
/// grad_x = F^-T grad_X. Collective on `communicator`, which holds the ranks
/// of both states.
class ImageForce {
public:
  ImageForce(std::shared_ptr<const Metric> metric, MPI_Comm communicator);

  SimilarityResult evaluate(const SimilarityDomain& domain,
                            const std::array<LoadedState, 2>& states,
                            Variable variable = Variable::displacement,
                            bool with_stiffness = false) const;

  /// The value alone.
  double value(const SimilarityDomain& domain, const std::array<LoadedState, 2>& states) const;

  /// (dS/dP_v)/(d^2S/dP_v^2)^1/2 of all voxels, on every rank: for the SSD h^{3/2} (P - S),
  /// whose squares add up to twice the value.
  std::vector<float> residuals(const SimilarityDomain& domain,
                               const std::array<LoadedState, 2>& states) const;

  /// The two warped images, on every rank, for pictures and other measures.
  WarpedPair warp(const SimilarityDomain& domain, const std::array<LoadedState, 2>& states) const;

private:
  struct Samples;

  WarpedPair combine(const SimilarityDomain& domain, const std::array<Samples, 2>& samples) const;

  std::shared_ptr<const Metric> metric_;
  MPI_Comm communicator_;
};

} // namespace prosup::similarity

#endif
