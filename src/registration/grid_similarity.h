#ifndef PROSUP_REGISTRATION_GRID_SIMILARITY_H
#define PROSUP_REGISTRATION_GRID_SIMILARITY_H

#include <array>
#include <memory>
#include <vector>

#include "prosup/fdm/vector_field.h"
#include "prosup/registration/body_pair.h"
#include "prosup/similarity/domain.h"
#include "prosup/similarity/image_force.h"

namespace prosup::registration {

/// One state as a displacement on a grid, null where another rank works on it.
struct GridState {
  const fdm::VectorField* displacement = nullptr; ///< u of the grid points, mm
  const image::ScalarImage* image = nullptr;      ///< in the loaded state
};

/// Smallest J = det dx/dX at the grid points with tissue, of this state.
double smallest_tissue_jacobian(const fdm::VectorField& displacement,
                                const similarity::Scene& scene, State which);

/// Compares images that displacements on grids warp to a common unloaded grid of voxels, and
/// finds the image forces at the points of the simulation grids. Voxels count where either
/// image has tissue and none has chest, an excluded region or the end of its field of view.
/// Collective on the world of the ranks.
class GridSimilarity {
public:
  /// Voxels of edge `level` mm around the tissue of both states as they are now. Keeps
  /// references to ranks and scene.
  GridSimilarity(const RankSplit& ranks, const similarity::Scene& scene,
                 std::shared_ptr<const similarity::Metric> metric,
                 const std::array<GridState, 2>& states, double level);

  double value(const std::array<GridState, 2>& states) const;
  /// As ImageForce::residuals().
  std::vector<float> residuals(const std::array<GridState, 2>& states) const;

  /// The value, and for each held state the force density at the points of its grid,
  ///   f_i = -sum_v dS/dP_v grad_x P(X_v + u) N_i(X_v)/h^3,
  /// N_i being the trilinear weight of a voxel at a point, so that f_i h^3 is minus the
  /// derivative of the value by u_i; [S]/mm^4. Variable::transformed_displacement has
  /// F F^T grad_x P = F grad_X P, the paper's.
  double forces(const std::array<GridState, 2>& states, similarity::Variable variable,
                std::array<fdm::VectorField, 2>& forces) const;

private:
  struct Samples;

  Samples sample(const GridState& state, State which) const;
  similarity::WarpedPair combine(const std::array<Samples, 2>& samples) const;
  std::array<Samples, 2> sample(const std::array<GridState, 2>& states) const;

  const RankSplit& ranks_;
  const similarity::Scene& scene_;
  std::shared_ptr<const similarity::Metric> metric_;
  image::VoxelGrid grid_;
};

} // namespace prosup::registration

#endif
