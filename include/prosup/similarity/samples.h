#ifndef PROSUP_SIMILARITY_SAMPLES_H
#define PROSUP_SIMILARITY_SAMPLES_H

#include <deal.II/base/tensor.h>
#include <mpi.h>

#include <cstdint>
#include <vector>

#include "prosup/core/position.h"
#include "prosup/similarity/domain.h"
#include "prosup/similarity/metric.h"

namespace prosup::similarity {

/// What a sample of an image shows. Voxels without a sample have 0, and count as air.
namespace cover {
constexpr float tissue = 1.f;
constexpr float near_tissue = 0.25f; ///< in one of the layers around a mesh
constexpr float air = 0.125f;        ///< seen to be air, with the intensity of the image
constexpr float excluded = -1.f;     ///< no force is computed here
} // namespace cover

/// The nodal positions by which the dissimilarity is differentiated; the others are held.
enum class Variable {
  displacement, ///< u at fixed X: dP(X_v) = grad_x P . N_a du_a
  /// F f of the paper's eq. 15, f having the gradient of the unloaded image grad_X P = F^T grad_x
  /// P. This is the derivative by u only where F F^T = 1.
  transformed_displacement,
  unloaded ///< X at fixed x: dP(X_v) = -(F^T grad_x P) . N_a dX_a, exact for linear cells
};

/// One loaded image at the voxels of a common unloaded grid, as far as one rank samples it. All
/// vectors have the same length. No voxel is sampled by two ranks.
struct Samples {
  std::vector<std::uint32_t> voxels;                  ///< linear indices in the grid
  std::vector<float> values;                          ///< P(X_v)
  std::vector<float> covers;                          ///< of namespace cover
  std::vector<dealii::Tensor<1, 3, float>> gradients; ///< grad_x P, 1/mm

  void reserve(std::size_t n);
  void add(std::uint32_t voxel, float value, float cover, const dealii::Tensor<1, 3>& gradient);
};

/// Both warped images on every rank, and the voxels that count. Collective on `communicator`,
/// which holds the ranks of both positions.
WarpedPair combine(const SimilarityDomain& domain, const PerPosition<const Samples*>& samples,
                   MPI_Comm communicator);

/// The dissimilarity of two warped images, with its derivatives by their values.
struct Dissimilarity {
  double value = 0.; ///< S, mm^3
  /// (sum_v slope_v^2)/(sum_v curvature_v)/h^3: the mean squared residual of the SSD, and its
  /// counterpart for other metrics. It scales as S does.
  double residual_variance = 0.;
  VoxelDerivatives derivatives;
};

/// Collective as combine(). Returns the same on every rank.
Dissimilarity evaluate(const Metric& metric, const SimilarityDomain& domain,
                       const PerPosition<const Samples*>& samples, MPI_Comm communicator);

} // namespace prosup::similarity

#endif
