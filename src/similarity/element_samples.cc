#include "prosup/similarity/element_samples.h"

#include <deal.II/base/mpi.h>

#include "cut_surfaces.h"
#include "prosup/image/sampling.h"
#include "prosup/mechanics/body/cell_edges.h"

namespace prosup::similarity {

using namespace dealii;
using mechanics::CellStiffness;
using mechanics::NodeVector;

namespace {

/// x - X of all local nodes.
NodeVector displacement_of(const ImagedBody& imaged) {
  NodeVector displacement = *imaged.unloaded;
  const NodeVector& loaded = imaged.body->vertex_positions();
  for (unsigned i = 0; i < 3 * imaged.body->n_local_nodes(); ++i)
    displacement.local_element(i) = loaded.local_element(i) - imaged.unloaded->local_element(i);
  return displacement;
}

} // namespace

ElementSamples::ElementSamples(const SimilarityDomain& domain, const ImagedBody& imaged,
                               const image::LabelImage* excluded)
    : imaged_(imaged) {
  if (imaged.body == nullptr)
    return;
  if (excluded != nullptr && excluded->values.empty())
    excluded = nullptr;
  const VoxelMap map(domain.grid, *imaged.body, *imaged.unloaded, domain.n_layers);
  const NodeVector displacement = displacement_of(imaged);
  const image::Sampler sampler(*imaged.image);
  voxels_ = map.voxels();
  samples_.reserve(voxels_.size());
  for (const VoxelMap::Voxel& voxel : voxels_) {
    Tensor<1, 3> gradient;
    const Point<3> position = map.loaded_position(voxel, displacement);
    const float value = sampler.value_and_gradient(position, gradient);
    const bool counts = excluded == nullptr || image::nearest_label(*excluded, position) == 0;
    samples_.add(voxel.index, value,
                 !counts                 ? cover::excluded
                 : voxel.beyond_boundary ? cover::near_tissue
                                         : cover::tissue,
                 gradient);
  }
  add_unknown(domain, map);
}

/// Voxels beyond the cuts are no air: the image does not know them.
void ElementSamples::add_unknown(const SimilarityDomain& domain, const VoxelMap& map) {
  const CutSurfaces cuts(*imaged_.body, *imaged_.unloaded, imaged_.image->grid.direction);
  if (cuts.empty() || Utilities::MPI::this_mpi_process(imaged_.body->communicator()) > 0)
    return;
  const auto& size = domain.grid.size;
  std::size_t v = 0;
  for (std::size_t k = 0; k < size[2]; ++k)
    for (std::size_t j = 0; j < size[1]; ++j)
      for (std::size_t i = 0; i < size[0]; ++i, ++v) {
        if (map.holds(v) || (!domain.no_air.empty() && domain.no_air[v]))
          continue; // the latter count where both images show tissue
        const Point<3> X = domain.grid.physical(double(i), double(j), double(k));
        if (cuts.beyond(X))
          samples_.add(static_cast<std::uint32_t>(v), 0.f, cover::excluded, {});
      }
}

void ElementSamples::derive_by(Variable variable) {
  if (imaged_.body == nullptr || variable == Variable::displacement)
    return;
  std::vector<Tensor<2, 3>> factors;
  factors.reserve(imaged_.body->cells().size());
  for (const auto& cell : imaged_.body->cells()) {
    const Tensor<2, 3> F = mechanics::cell_edges(cell, imaged_.body->vertex_positions()) *
                           invert(mechanics::cell_edges(cell, *imaged_.unloaded));
    factors.push_back(variable == Variable::unloaded ? -transpose(F) : F * transpose(F));
  }
  for (std::size_t i = 0; i < voxels_.size(); ++i)
    samples_.gradients[i] = factors[voxels_[i].cell] * Tensor<1, 3>(samples_.gradients[i]);
}

NodeVector ElementSamples::forces(const std::vector<float>& slope) const {
  NodeVector forces;
  if (imaged_.body == nullptr)
    return forces;
  imaged_.body->initialize(forces);
  for (std::size_t i = 0; i < voxels_.size(); ++i) {
    const Tensor<1, 3> force =
        -static_cast<double>(slope[voxels_[i].index]) * Tensor<1, 3>(samples_.gradients[i]);
    for (unsigned a = 0; a < 4; ++a)
      for (unsigned c = 0; c < 3; ++c)
        forces.local_element(3 * imaged_.body->cells()[voxels_[i].cell][a] + c) +=
            voxels_[i].weights[a] * force[c];
  }
  forces.compress(VectorOperation::add);
  return forces;
}

std::vector<CellStiffness> ElementSamples::stiffness(const std::vector<float>& curvature) const {
  std::vector<CellStiffness> cells(imaged_.body == nullptr ? 0 : imaged_.body->cells().size());
  for (std::size_t i = 0; i < voxels_.size(); ++i) {
    const VoxelMap::Voxel& voxel = voxels_[i];
    const Tensor<1, 3> gradient(samples_.gradients[i]);
    const SymmetricTensor<2, 3> stiffness =
        static_cast<double>(curvature[voxel.index]) * symmetrize(outer_product(gradient, gradient));
    unsigned pair = 0;
    for (unsigned a = 0; a < 4; ++a)
      for (unsigned b = a; b < 4; ++b, ++pair)
        cells[voxel.cell][pair] +=
            static_cast<double>(voxel.weights[a] * voxel.weights[b]) * stiffness;
  }
  return cells;
}

} // namespace prosup::similarity
