#ifndef PROSUP_SRC_FDM_SLAB_H
#define PROSUP_SRC_FDM_SLAB_H

#include <mpi.h>

#include <cstddef>
#include <vector>

#include "prosup/image/voxel_image.h"

namespace prosup::fdm {

/// Precision of the simulation; sums are in double.
using Real = float;
/// One value at each node of a slab.
using NodalField = std::vector<Real>;

/// The planes of a grid that one rank owns, with one plane below and one above them, which
/// belong to its neighbours (or, at the ends of the grid, to no rank). Local nodes are
/// numbered from the plane below, x fastest.
class Slab {
public:
  Slab(const image::VoxelGrid& grid, MPI_Comm communicator);

  const image::VoxelGrid& grid() const { return grid_; }
  MPI_Comm communicator() const { return communicator_; }
  std::size_t row() const { return grid_.size[0]; }
  std::size_t plane() const { return grid_.size[0] * grid_.size[1]; }
  /// Number of nodes in memory.
  std::size_t n_nodes() const { return (n_planes_ + 2) * plane(); }
  /// Local numbers of the nodes owned.
  std::size_t owned_begin() const { return plane(); }
  std::size_t owned_end() const { return (n_planes_ + 1) * plane(); }
  dealii::Point<3> position(std::size_t node) const;
  /// Whether a node is on the border of the grid (or beyond it).
  bool on_border(std::size_t node) const;

  /// Receives the planes below and above from the neighbours.
  void exchange(NodalField& field) const;
  /// The values of all nodes of the grid, on all ranks.
  NodalField gather(const NodalField& field) const;

private:
  image::VoxelGrid grid_;
  MPI_Comm communicator_;
  int n_ranks_ = 1, rank_ = 0;
  int below_ = MPI_PROC_NULL, above_ = MPI_PROC_NULL;
  std::vector<std::size_t> first_planes_; ///< of each rank, and the number of planes
  std::size_t first_plane_ = 0, n_planes_ = 0;
};

} // namespace prosup::fdm

#endif
