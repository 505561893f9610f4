#include "prosup/similarity/voxel_map.h"

#include <algorithm>
#include <unordered_map>

#include "prosup/mechanics/body/cell_edges.h"
#include "prosup/mesh/scan_conversion.h"

namespace prosup::similarity {

using namespace dealii;
using mechanics::node_value;
using mechanics::NodeVector;

namespace {

constexpr std::int32_t nobody = 0; // owners are cell ids + 1

/// Barycentric weights of a cell as affine functions of the position.
struct Barycentric {
  Point<3> origin;
  Tensor<2, 3> inverse_edges;

  Barycentric(const std::array<unsigned, 4>& corners, const NodeVector& positions)
      : origin(node_value(positions, corners[0])),
        inverse_edges(invert(mechanics::cell_edges(corners, positions))) {}

  std::array<double, 4> weights(const Point<3>& position) const {
    const Tensor<1, 3> w = inverse_edges * (position - origin);
    return {1. - w[0] - w[1] - w[2], w[0], w[1], w[2]};
  }
};

/// Weights of a point of the cell near to the given one: negative weights are
/// cut, so that a flat cell does not extrapolate wildly.
std::array<double, 4> clamped(std::array<double, 4> weights) {
  double sum = 0.;
  for (double& w : weights)
    sum += w = std::max(w, 0.);
  for (double& w : weights)
    w /= sum;
  return weights;
}

} // namespace

VoxelMap::VoxelMap(const image::VoxelGrid& grid, const mechanics::Body& body,
                   const NodeVector& unloaded, unsigned n_layers)
    : grid_(grid), body_(body) {
  std::vector<std::int32_t> owner = claim_voxels(unloaded);
  std::vector<bool> inside(owner.size());
  std::transform(owner.begin(), owner.end(), inside.begin(),
                 [](std::int32_t cell) { return cell != nobody; });
  for (unsigned layer = 0; layer < n_layers; ++layer)
    add_layer(owner);
  held_.resize(owner.size());
  std::transform(owner.begin(), owner.end(), held_.begin(),
                 [](std::int32_t cell) { return cell != nobody; });
  compute_weights(owner, inside, unloaded);
}

std::vector<std::int32_t> VoxelMap::claim_voxels(const NodeVector& unloaded) const {
  std::vector<std::int32_t> owner(grid_.n_voxels(), nobody);
  for (std::size_t cell = 0; cell < body_.cells().size(); ++cell) {
    const std::int32_t id = static_cast<std::int32_t>(body_.cell_ids()[cell]) + 1;
    std::array<Point<3>, 4> corners;
    for (unsigned a = 0; a < 4; ++a)
      corners[a] = Point<3>(node_value(unloaded, body_.cells()[cell][a]));
    mesh::scan_convert_tet(grid_, corners,
                           [&](std::size_t i, std::size_t j, std::size_t k, const auto&) {
                             std::int32_t& o = owner[grid_.linear_index(i, j, k)];
                             o = std::max(o, id);
                           });
  }
  int n_ranks = 1;
  MPI_Comm_size(body_.communicator(), &n_ranks);
  if (n_ranks > 1)
    MPI_Allreduce(MPI_IN_PLACE, owner.data(), static_cast<int>(owner.size()), MPI_INT32_T, MPI_MAX,
                  body_.communicator());
  return owner;
}

void VoxelMap::add_layer(std::vector<std::int32_t>& owner) const {
  const std::vector<std::int32_t> before = owner;
  const std::size_t stride[3] = {1, grid_.size[0], grid_.size[0] * grid_.size[1]};
  std::size_t index = 0;
  for (std::size_t k = 0; k < grid_.size[2]; ++k)
    for (std::size_t j = 0; j < grid_.size[1]; ++j)
      for (std::size_t i = 0; i < grid_.size[0]; ++i, ++index) {
        if (before[index] != nobody)
          continue;
        const std::size_t position[3] = {i, j, k};
        for (unsigned d = 0; d < 3; ++d) {
          if (position[d] > 0)
            owner[index] = std::max(owner[index], before[index - stride[d]]);
          if (position[d] + 1 < grid_.size[d])
            owner[index] = std::max(owner[index], before[index + stride[d]]);
        }
      }
}

void VoxelMap::compute_weights(const std::vector<std::int32_t>& owner,
                               const std::vector<bool>& inside, const NodeVector& unloaded) {
  std::unordered_map<std::int32_t, std::uint32_t> local_cell;
  std::vector<Barycentric> barycentric;
  barycentric.reserve(body_.cells().size());
  for (std::uint32_t cell = 0; cell < body_.cells().size(); ++cell) {
    local_cell[static_cast<std::int32_t>(body_.cell_ids()[cell]) + 1] = cell;
    barycentric.emplace_back(body_.cells()[cell], unloaded);
  }
  std::size_t index = 0;
  for (std::size_t k = 0; k < grid_.size[2]; ++k)
    for (std::size_t j = 0; j < grid_.size[1]; ++j)
      for (std::size_t i = 0; i < grid_.size[0]; ++i, ++index) {
        if (owner[index] == nobody)
          continue;
        const auto found = local_cell.find(owner[index]);
        if (found == local_cell.end())
          continue;
        const Point<3> position =
            grid_.physical(static_cast<double>(i), static_cast<double>(j), static_cast<double>(k));
        std::array<double, 4> weights = barycentric[found->second].weights(position);
        if (!inside[index])
          weights = clamped(weights);
        Voxel voxel{static_cast<std::uint32_t>(index), found->second, {}, !inside[index]};
        std::copy(weights.begin(), weights.end(), voxel.weights.begin());
        voxels_.push_back(voxel);
      }
}

Point<3> VoxelMap::loaded_position(const Voxel& voxel, const NodeVector& displacement) const {
  const std::size_t i = voxel.index % grid_.size[0];
  const std::size_t j = voxel.index / grid_.size[0] % grid_.size[1];
  const std::size_t k = voxel.index / (grid_.size[0] * grid_.size[1]);
  Point<3> position =
      grid_.physical(static_cast<double>(i), static_cast<double>(j), static_cast<double>(k));
  for (unsigned a = 0; a < 4; ++a)
    position += voxel.weights[a] * node_value(displacement, body_.cells()[voxel.cell][a]);
  return position;
}

} // namespace prosup::similarity
