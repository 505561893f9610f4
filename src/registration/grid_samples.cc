#include "grid_samples.h"

#include <deal.II/base/mpi.h>

#include <utility>

#include "prosup/fdm/trilinear_cell.h"
#include "prosup/image/sampling.h"

namespace prosup::registration {

using namespace dealii;
using fdm::VectorField;
using similarity::Variable;
namespace cover = similarity::cover;

float cover_at(const similarity::Scene& scene, Position position, const Point<3>& x) {
  const image::LabelImage& labels = scene.labels[position];
  const Point<3> index = labels.grid.continuous_index(x);
  for (unsigned d = 0; d < 3; ++d)
    if (!(index[d] > -0.5 && index[d] < static_cast<double>(labels.grid.size[d]) - 0.5))
      return cover::excluded;
  const unsigned label = image::nearest_label(labels, x);
  if (label == scene.chest_label || (!scene.excluded[position].values.empty() &&
                                     image::nearest_label(scene.excluded[position], x) != 0))
    return cover::excluded;
  return label == 0 ? cover::air : cover::tissue;
}

Tensor<2, 3> deformation_gradient(const VectorField& u, const Point<3>& X) {
  Tensor<2, 3> F(unit_symmetric_tensor<3>());
  const double half = 0.5 * u.grid.spacing[0];
  for (unsigned d = 0; d < 3; ++d) {
    Tensor<1, 3> step;
    step[d] = half;
    const Tensor<1, 3> slope = (u.value(X + step) - u.value(X - step)) / (2. * half);
    for (unsigned c = 0; c < 3; ++c)
      F[c][d] += slope[c];
  }
  return F;
}

GridSamples::GridSamples(const similarity::SimilarityDomain& domain, const similarity::Scene& scene,
                         Position position, VectorField displacement,
                         const image::ScalarImage& image, MPI_Comm communicator)
    : grid_(domain.grid), displacement_(std::move(displacement)), communicator_(communicator) {
  const image::Sampler sampler(image);
  const std::size_t plane = grid_.size[0] * grid_.size[1];
  const unsigned n_ranks = Utilities::MPI::n_mpi_processes(communicator);
  const unsigned rank = Utilities::MPI::this_mpi_process(communicator);
  samples_.reserve(plane * ((grid_.size[2] + n_ranks - 1) / n_ranks));
  for (std::size_t k = rank; k < grid_.size[2]; k += n_ranks)
    for (std::size_t v = k * plane; v < (k + 1) * plane; ++v) {
      const auto voxel = static_cast<std::uint32_t>(v);
      const Point<3> X = position_of(voxel);
      const Point<3> x = X + displacement_.value(X);
      const float cover = cover_at(scene, position, x);
      Tensor<1, 3> gradient;
      const float value = cover == cover::excluded ? 0.f : sampler.value_and_gradient(x, gradient);
      samples_.add(voxel, value, cover, gradient);
    }
}

Point<3> GridSamples::position_of(std::uint32_t voxel) const {
  const std::size_t i = voxel % grid_.size[0];
  const std::size_t j = voxel / grid_.size[0] % grid_.size[1];
  const std::size_t k = voxel / (grid_.size[0] * grid_.size[1]);
  return grid_.physical(static_cast<double>(i), static_cast<double>(j), static_cast<double>(k));
}

VectorField GridSamples::forces(const std::vector<float>& slope, Variable variable) const {
  VectorField forces{displacement_.grid, std::vector<Tensor<1, 3>>(displacement_.values.size())};
  const double density = 1. / displacement_.grid.voxel_volume();
  for (std::size_t i = 0; i < samples_.voxels.size(); ++i) {
    const double voxel_slope = slope[samples_.voxels[i]];
    if (voxel_slope == 0.)
      continue;
    const Point<3> X = position_of(samples_.voxels[i]);
    Tensor<1, 3> force = -voxel_slope * density * Tensor<1, 3>(samples_.gradients[i]);
    if (variable == Variable::transformed_displacement) {
      const Tensor<2, 3> F = deformation_gradient(displacement_, X);
      force = F * (transpose(F) * force);
    }
    const fdm::TrilinearCell cell(displacement_.grid, X);
    for (unsigned corner = 0; corner < 8; ++corner)
      forces.values[cell.node(corner)] += cell.weight(corner) * force;
  }
  MPI_Allreduce(MPI_IN_PLACE, forces.values.data(), static_cast<int>(3 * forces.values.size()),
                MPI_DOUBLE, MPI_SUM, communicator_);
  return forces;
}

} // namespace prosup::registration
