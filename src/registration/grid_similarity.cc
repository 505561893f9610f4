#include "grid_similarity.h"

#include <deal.II/base/mpi.h>

#include <cmath>
#include <limits>
#include <utility>

#include "prosup/fdm/trilinear_cell.h"
#include "prosup/image/sampling.h"

namespace prosup::registration {

using namespace dealii;
using fdm::VectorField;
using similarity::prone;
using similarity::supine;
using similarity::Variable;
using similarity::VoxelDerivatives;
using similarity::WarpedPair;

namespace {

constexpr std::array<State, 2> both{prone, supine};

// What is at a voxel in the loaded image; numbers that a sum over ranks keeps.
constexpr float air = 0.f, tissue = 1.f, no_force = 2.f;

float content(const similarity::Scene& scene, State which, const Point<3>& x) {
  const image::LabelImage& labels = scene.labels[which];
  const Point<3> index = labels.grid.continuous_index(x);
  for (unsigned d = 0; d < 3; ++d)
    if (!(index[d] > -0.5 && index[d] < static_cast<double>(labels.grid.size[d]) - 0.5))
      return no_force;
  const unsigned label = image::nearest_label(labels, x);
  if (label == scene.chest_label || (!scene.excluded[which].values.empty() &&
                                     image::nearest_label(scene.excluded[which], x) != 0))
    return no_force;
  return label == 0 ? air : tissue;
}

/// Voxels of edge `spacing` around all unloaded tissue.
image::VoxelGrid common_grid(const RankSplit& ranks, const similarity::Scene& scene,
                             const std::array<GridState, 2>& states, double spacing) {
  double ends[6]; // lower ones as negative numbers
  std::fill(ends, ends + 6, -std::numeric_limits<double>::max());
  for (const State s : both) {
    if (states[s].displacement == nullptr)
      continue;
    const VectorField& u = *states[s].displacement;
    std::size_t node = 0;
    for (std::size_t k = 0; k < u.grid.size[2]; ++k)
      for (std::size_t j = 0; j < u.grid.size[1]; ++j)
        for (std::size_t i = 0; i < u.grid.size[0]; ++i, ++node) {
          const Point<3> X = u.grid.physical(static_cast<double>(i), static_cast<double>(j),
                                             static_cast<double>(k));
          if (content(scene, s, X + u.values[node]) != tissue)
            continue;
          for (unsigned d = 0; d < 3; ++d) {
            ends[d] = std::max(ends[d], -X[d]);
            ends[3 + d] = std::max(ends[3 + d], X[d]);
          }
        }
  }
  MPI_Allreduce(MPI_IN_PLACE, ends, 6, MPI_DOUBLE, MPI_MAX, ranks.world());
  // Tissue goes on beyond the last point; both grids have the same spacing.
  double beyond = 0.;
  for (const GridState& state : states)
    if (state.displacement != nullptr)
      beyond = state.displacement->grid.spacing[0];
  for (double& end : ends)
    end += beyond;
  return image::grid_around(Point<3>(-ends[0], -ends[1], -ends[2]),
                            Point<3>(ends[3], ends[4], ends[5]), spacing, spacing);
}

/// F = 1 + du/dX of trilinear u, by differences over the cell.
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

} // namespace

double smallest_tissue_jacobian(const VectorField& u, const similarity::Scene& scene, State which) {
  double smallest = std::numeric_limits<double>::max();
  std::size_t node = 0;
  for (std::size_t k = 0; k < u.grid.size[2]; ++k)
    for (std::size_t j = 0; j < u.grid.size[1]; ++j)
      for (std::size_t i = 0; i < u.grid.size[0]; ++i, ++node) {
        const Point<3> X =
            u.grid.physical(static_cast<double>(i), static_cast<double>(j), static_cast<double>(k));
        if (content(scene, which, X + u.values[node]) == tissue)
          smallest = std::min(smallest, determinant(deformation_gradient(u, X)));
      }
  return smallest;
}

/// What one rank knows of one state: voxels with tissue and around it.
struct GridSimilarity::Samples {
  std::vector<std::size_t> voxels;
  std::vector<Point<3>> positions; ///< X
  std::vector<float> values, contents;
  std::vector<Tensor<1, 3, float>> gradients; ///< grad_x P
};

GridSimilarity::GridSimilarity(const RankSplit& ranks, const similarity::Scene& scene,
                               std::shared_ptr<const similarity::Metric> metric,
                               const std::array<GridState, 2>& states, double level)
    : ranks_(ranks), scene_(scene), metric_(std::move(metric)),
      grid_(common_grid(ranks, scene, states, level)) {}

GridSimilarity::Samples GridSimilarity::sample(const GridState& state, State which) const {
  Samples samples;
  if (state.displacement == nullptr)
    return samples;
  const image::Sampler sampler(*state.image);
  // Planes are dealt out to the ranks of the state.
  const unsigned n_ranks = Utilities::MPI::n_mpi_processes(ranks_.group());
  const unsigned rank = Utilities::MPI::this_mpi_process(ranks_.group());
  for (std::size_t k = rank; k < grid_.size[2]; k += n_ranks)
    for (std::size_t j = 0; j < grid_.size[1]; ++j)
      for (std::size_t i = 0; i < grid_.size[0]; ++i) {
        const Point<3> X =
            grid_.physical(static_cast<double>(i), static_cast<double>(j), static_cast<double>(k));
        const Point<3> x = X + state.displacement->value(X);
        const float here = content(scene_, which, x);
        Tensor<1, 3> gradient;
        samples.voxels.push_back(i + grid_.size[0] * (j + grid_.size[1] * k));
        samples.positions.push_back(X);
        samples.values.push_back(here == no_force ? 0.f : sampler.value_and_gradient(x, gradient));
        samples.gradients.emplace_back(gradient);
        samples.contents.push_back(here);
      }
  return samples;
}

std::array<GridSimilarity::Samples, 2>
GridSimilarity::sample(const std::array<GridState, 2>& states) const {
  return {sample(states[prone], prone), sample(states[supine], supine)};
}

WarpedPair GridSimilarity::combine(const std::array<Samples, 2>& samples) const {
  const std::size_t n = grid_.n_voxels();
  std::array<std::vector<float>, 2> contents;
  WarpedPair pair{grid_, {}, std::vector<std::uint8_t>(n, 0)};
  for (const State s : both) {
    contents[s].assign(n, 0.f);
    std::vector<float>& values = pair.values[both_positions[s]];
    values.assign(n, 0.f);
    for (std::size_t i = 0; i < samples[s].voxels.size(); ++i) {
      values[samples[s].voxels[i]] = samples[s].values[i];
      contents[s][samples[s].voxels[i]] = samples[s].contents[i];
    }
    for (std::vector<float>* part : {&values, &contents[s]})
      MPI_Allreduce(MPI_IN_PLACE, part->data(), static_cast<int>(n), MPI_FLOAT, MPI_SUM,
                    ranks_.world());
  }
  for (std::size_t v = 0; v < n; ++v)
    pair.in_domain[v] = (contents[prone][v] == tissue || contents[supine][v] == tissue) &&
                        contents[prone][v] != no_force && contents[supine][v] != no_force;
  return pair;
}

double GridSimilarity::value(const std::array<GridState, 2>& states) const {
  VoxelDerivatives derivatives;
  return metric_->evaluate(combine(sample(states)), derivatives);
}

std::vector<float> GridSimilarity::residuals(const std::array<GridState, 2>& states) const {
  VoxelDerivatives derivatives;
  metric_->evaluate(combine(sample(states)), derivatives);
  return similarity::residuals_of(std::move(derivatives));
}

double GridSimilarity::forces(const std::array<GridState, 2>& states, Variable variable,
                              std::array<VectorField, 2>& forces) const {
  const std::array<Samples, 2> samples = sample(states);
  VoxelDerivatives derivatives;
  const double value = metric_->evaluate(combine(samples), derivatives);
  for (const State s : both) {
    if (states[s].displacement == nullptr)
      continue;
    const VectorField& u = *states[s].displacement;
    forces[s] = {u.grid, std::vector<Tensor<1, 3>>(u.values.size())};
    const double density = 1. / u.grid.voxel_volume();
    for (std::size_t i = 0; i < samples[s].voxels.size(); ++i) {
      const double slope = derivatives.slope[both_positions[s]][samples[s].voxels[i]];
      if (slope == 0.)
        continue;
      const Point<3>& X = samples[s].positions[i];
      Tensor<1, 3> force = -slope * density * Tensor<1, 3>(samples[s].gradients[i]);
      if (variable == Variable::transformed_displacement) {
        const Tensor<2, 3> F = deformation_gradient(u, X);
        force = F * (transpose(F) * force);
      }
      const fdm::TrilinearCell cell(u.grid, X);
      for (unsigned corner = 0; corner < 8; ++corner)
        forces[s].values[cell.node(corner)] += cell.weight(corner) * force;
    }
    MPI_Allreduce(MPI_IN_PLACE, forces[s].values.data(),
                  static_cast<int>(3 * forces[s].values.size()), MPI_DOUBLE, MPI_SUM,
                  ranks_.group());
  }
  return value;
}

} // namespace prosup::registration
