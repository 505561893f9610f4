#ifndef PROSUP_SIMILARITY_VOXEL_MAP_H
#define PROSUP_SIMILARITY_VOXEL_MAP_H

#include <array>
#include <cstdint>
#include <vector>

#include "prosup/image/voxel_image.h"
#include "prosup/mechanics/body/body.h"

namespace prosup::similarity {

/// Where the voxels of an unloaded grid lie in the mesh of a body. A voxel at
/// X_v in cell e with barycentric weights N_a comes from the loaded position
///   x(X_v) = X_v + sum_a N_a(X_v) (x_a - X_a),
/// and a force on it acts on the nodes of e in the parts N_a. Collective on
/// the body's communicator; each rank keeps the voxels of its own cells, and
/// every voxel belongs to one rank only, whatever the partition.
class VoxelMap {
public:
  /// A voxel in the mesh or in one of the layers around it.
  struct Voxel {
    std::uint32_t index;          ///< linear index in the grid
    std::uint32_t cell;           ///< in Body::cells()
    std::array<float, 4> weights; ///< N_a, sum 1
    bool beyond_boundary;         ///< one of the layers added outside the mesh
  };

  /// `n_layers` layers of voxels around the mesh take the weights of the
  /// nearest point of a neighbouring cell: half of the skin's image edge lies
  /// outside the mesh, and without them the skin would feel no force.
  VoxelMap(const image::VoxelGrid& grid, const mechanics::Body& body,
           const mechanics::NodeVector& unloaded, unsigned n_layers);

  const std::vector<Voxel>& voxels() const { return voxels_; }

  /// Whether a voxel lies in the mesh or in one of the layers around it, on whatever rank.
  bool holds(std::size_t index) const { return held_[index]; }

  /// x(X_v), mm. `displacement` holds x_a - X_a.
  dealii::Point<3> loaded_position(const Voxel& voxel,
                                   const mechanics::NodeVector& displacement) const;

private:
  std::vector<std::int32_t> claim_voxels(const mechanics::NodeVector& unloaded) const;
  void add_layer(std::vector<std::int32_t>& owner) const;
  void compute_weights(const std::vector<std::int32_t>& owner, const std::vector<bool>& inside,
                       const mechanics::NodeVector& unloaded);

  const image::VoxelGrid grid_;
  const mechanics::Body& body_;
  std::vector<Voxel> voxels_;
  std::vector<bool> held_;
};

} // namespace prosup::similarity

#endif
