#ifndef PROSUP_SRC_REGISTRATION_GRID_SAMPLES_H
#define PROSUP_SRC_REGISTRATION_GRID_SAMPLES_H

#include <mpi.h>

#include <vector>

#include "prosup/fdm/vector_field.h"
#include "prosup/similarity/samples.h"

namespace prosup::registration {

/// What the loaded image of a position shows at x, of namespace similarity::cover: tissue, air, or
/// excluded in the chest wall, in excluded regions and beyond the field of view.
float cover_at(const similarity::Scene& scene, Position position, const dealii::Point<3>& x);

/// F = 1 + du/dX of trilinear u at X, by differences over the cell.
dealii::Tensor<2, 3> deformation_gradient(const fdm::VectorField& displacement,
                                          const dealii::Point<3>& X);

/// The image of a breast whose displacement u is known on a regular grid, at the voxels of another
/// one, and the way back: forces on voxels become force densities at the grid points. The planes
/// of voxels are dealt out to the ranks of `communicator`.
class GridSamples {
public:
  /// Keeps a reference to the grid of `domain`.
  GridSamples(const similarity::SimilarityDomain& domain, const similarity::Scene& scene,
              Position position, fdm::VectorField displacement, const image::ScalarImage& image,
              MPI_Comm communicator);

  const similarity::Samples& samples() const { return samples_; }

  /// The force density at the points of the displacement's grid, [S]/mm^4,
  ///   f_i = -sum_v slope_v grad_x P(X_v + u) N_i(X_v)/h^3,
  /// N_i being the trilinear weight of a voxel at a point, so that f_i h^3 is minus the derivative
  /// of the value by u_i. Variable::transformed_displacement has F F^T grad_x P = F grad_X P, the
  /// paper's. Collective.
  fdm::VectorField forces(const std::vector<float>& slope, similarity::Variable variable) const;

private:
  dealii::Point<3> position_of(std::uint32_t voxel) const;

  const image::VoxelGrid grid_;
  const fdm::VectorField displacement_;
  MPI_Comm communicator_;
  similarity::Samples samples_;
};

} // namespace prosup::registration

#endif
