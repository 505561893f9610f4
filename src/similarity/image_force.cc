#include "prosup/similarity/image_force.h"

#include <cmath>
#include <utility>

#include "prosup/image/sampling.h"
#include "prosup/mechanics/body/cell_edges.h"
#include "prosup/similarity/voxel_map.h"

namespace prosup::similarity {

using namespace dealii;
using mechanics::CellStiffness;
using mechanics::NodeVector;

namespace {

// How sure a warped image is of a voxel.
constexpr float in_mesh = 1.f;
constexpr float beyond_boundary = 0.25f;
constexpr float excluded = -1.f;

NodeVector displacement_of(const LoadedState& state) {
  NodeVector displacement = *state.unloaded;
  const NodeVector& loaded = state.body->vertex_positions();
  for (unsigned i = 0; i < 3 * state.body->n_local_nodes(); ++i)
    displacement.local_element(i) = loaded.local_element(i) - state.unloaded->local_element(i);
  return displacement;
}

double residual_variance(const VoxelDerivatives& derivatives, double voxel_volume) {
  double slopes = 0., curvatures = 0.;
  for (const Position p : both_positions) {
    for (const double slope : derivatives.slope[p])
      slopes += slope * slope;
    for (const double curvature : derivatives.curvature[p])
      curvatures += curvature;
  }
  return curvatures > 0. ? slopes / curvatures / voxel_volume : 0.;
}

bool counts(float prone_cover, float supine_cover, bool no_air) {
  if (prone_cover == excluded || supine_cover == excluded)
    return false;
  if (prone_cover == 0.f && supine_cover == 0.f)
    return false;
  const bool both = prone_cover > 0.f && supine_cover > 0.f;
  const bool any_in_mesh = prone_cover == in_mesh || supine_cover == in_mesh;
  return !no_air || (both && any_in_mesh);
}

} // namespace

/// One state's image at the voxels of its map, with gradients grad_x P.
struct ImageForce::Samples {
  std::vector<VoxelMap::Voxel> voxels;
  std::vector<float> values;
  std::vector<float> cover;
  std::vector<Tensor<1, 3, float>> gradients;

  Samples() = default;
  Samples(const SimilarityDomain& domain, const LoadedState& state, State which) {
    if (state.body == nullptr)
      return;
    const VoxelMap map(domain.grid, *state.body, *state.unloaded, domain.n_layers);
    const NodeVector displacement = displacement_of(state);
    const image::Sampler sampler(*state.image);
    const image::LabelImage* mask =
        domain.excluded == nullptr ? nullptr : &(*domain.excluded)[which];
    if (mask != nullptr && mask->values.empty())
      mask = nullptr;
    voxels = map.voxels();
    values.reserve(voxels.size());
    gradients.reserve(voxels.size());
    for (const VoxelMap::Voxel& voxel : voxels) {
      Tensor<1, 3> gradient;
      const Point<3> position = map.loaded_position(voxel, displacement);
      values.push_back(sampler.value_and_gradient(position, gradient));
      gradients.emplace_back(gradient);
      cover.push_back(voxel.beyond_boundary ? beyond_boundary : in_mesh);
      if (mask != nullptr && image::nearest_label(*mask, position) != 0)
        cover.back() = excluded;
    }
  }

  /// Makes of grad_x P what takes its place in derivatives by the variable.
  void derive_by(Variable variable, const LoadedState& state) {
    if (state.body == nullptr || variable == Variable::displacement)
      return;
    std::vector<Tensor<2, 3>> factors;
    factors.reserve(state.body->cells().size());
    for (const auto& cell : state.body->cells()) {
      const Tensor<2, 3> F = mechanics::cell_edges(cell, state.body->vertex_positions()) *
                             invert(mechanics::cell_edges(cell, *state.unloaded));
      factors.push_back(variable == Variable::unloaded ? -transpose(F) : F * transpose(F));
    }
    for (std::size_t i = 0; i < voxels.size(); ++i)
      gradients[i] = factors[voxels[i].cell] * Tensor<1, 3>(gradients[i]);
  }

  NodeVector forces(const LoadedState& state, const std::vector<float>& slope) const {
    NodeVector forces;
    if (state.body == nullptr)
      return forces;
    state.body->initialize(forces);
    for (std::size_t i = 0; i < voxels.size(); ++i) {
      const Tensor<1, 3> force =
          -static_cast<double>(slope[voxels[i].index]) * Tensor<1, 3>(gradients[i]);
      for (unsigned a = 0; a < 4; ++a)
        for (unsigned c = 0; c < 3; ++c)
          forces.local_element(3 * state.body->cells()[voxels[i].cell][a] + c) +=
              voxels[i].weights[a] * force[c];
    }
    forces.compress(VectorOperation::add);
    return forces;
  }

  std::vector<CellStiffness> stiffness(const LoadedState& state,
                                       const std::vector<float>& curvature) const {
    std::vector<CellStiffness> cells(state.body == nullptr ? 0 : state.body->cells().size());
    for (std::size_t i = 0; i < voxels.size(); ++i) {
      const VoxelMap::Voxel& voxel = voxels[i];
      const Tensor<1, 3> gradient(gradients[i]);
      const SymmetricTensor<2, 3> stiffness = static_cast<double>(curvature[voxel.index]) *
                                              symmetrize(outer_product(gradient, gradient));
      unsigned pair = 0;
      for (unsigned a = 0; a < 4; ++a)
        for (unsigned b = a; b < 4; ++b, ++pair)
          cells[voxel.cell][pair] +=
              static_cast<double>(voxel.weights[a] * voxel.weights[b]) * stiffness;
    }
    return cells;
  }
};

ImageForce::ImageForce(std::shared_ptr<const Metric> metric, MPI_Comm communicator)
    : metric_(std::move(metric)), communicator_(communicator) {}

WarpedPair ImageForce::combine(const SimilarityDomain& domain,
                               const std::array<Samples, 2>& samples) const {
  // Each voxel of a state belongs to one rank, so that sums put them together.
  const std::size_t n = domain.grid.n_voxels();
  std::vector<float> packed(4 * n, 0.f);
  for (unsigned s = 0; s < 2; ++s)
    for (std::size_t i = 0; i < samples[s].voxels.size(); ++i) {
      const VoxelMap::Voxel& voxel = samples[s].voxels[i];
      packed[2 * s * n + voxel.index] = samples[s].values[i];
      packed[(2 * s + 1) * n + voxel.index] = samples[s].cover[i];
    }
  for (unsigned part = 0; part < 4; ++part)
    MPI_Allreduce(MPI_IN_PLACE, packed.data() + part * n, static_cast<int>(n), MPI_FLOAT, MPI_SUM,
                  communicator_);

  WarpedPair pair{domain.grid, {}, std::vector<std::uint8_t>(n, 0)};
  for (unsigned s = 0; s < 2; ++s) {
    std::vector<float>& values = pair.values[both_positions[s]];
    values.assign(n, domain.air[s]);
    for (std::size_t v = 0; v < n; ++v)
      if (packed[(2 * s + 1) * n + v] != 0.f)
        values[v] = packed[2 * s * n + v];
  }
  for (std::size_t v = 0; v < n; ++v)
    pair.in_domain[v] = counts(packed[n + v], packed[3 * n + v], domain.no_air[v]);
  return pair;
}

SimilarityResult ImageForce::evaluate(const SimilarityDomain& domain,
                                      const std::array<LoadedState, 2>& states, Variable variable,
                                      bool with_stiffness) const {
  std::array<Samples, 2> samples{Samples(domain, states[prone], prone),
                                 Samples(domain, states[supine], supine)};
  VoxelDerivatives derivatives;
  SimilarityResult result;
  result.value = metric_->evaluate(combine(domain, samples), derivatives);
  result.residual_variance = residual_variance(derivatives, domain.grid.voxel_volume());
  for (unsigned s = 0; s < 2; ++s) {
    samples[s].derive_by(variable, states[s]);
    result.forces[s] = samples[s].forces(states[s], derivatives.slope[both_positions[s]]);
    if (with_stiffness)
      result.stiffness[s] =
          samples[s].stiffness(states[s], derivatives.curvature[both_positions[s]]);
  }
  return result;
}

double ImageForce::value(const SimilarityDomain& domain,
                         const std::array<LoadedState, 2>& states) const {
  VoxelDerivatives derivatives;
  return metric_->evaluate(warp(domain, states), derivatives);
}

std::vector<float> ImageForce::residuals(const SimilarityDomain& domain,
                                         const std::array<LoadedState, 2>& states) const {
  VoxelDerivatives derivatives;
  metric_->evaluate(warp(domain, states), derivatives);
  return residuals_of(std::move(derivatives));
}

WarpedPair ImageForce::warp(const SimilarityDomain& domain,
                            const std::array<LoadedState, 2>& states) const {
  return combine(domain,
                 {Samples(domain, states[prone], prone), Samples(domain, states[supine], supine)});
}

} // namespace prosup::similarity
