#include "slab.h"

#include <algorithm>

namespace prosup::fdm {

Slab::Slab(const image::VoxelGrid& grid, MPI_Comm communicator)
    : grid_(grid), communicator_(communicator) {
  MPI_Comm_size(communicator, &n_ranks_);
  MPI_Comm_rank(communicator, &rank_);
  // More ranks than planes: the last ones own none.
  const std::size_t n_total = grid.size[2];
  const std::size_t n_working = std::min<std::size_t>(n_ranks_, n_total);
  for (int rank = 0; rank <= n_ranks_; ++rank)
    first_planes_.push_back(std::min<std::size_t>(rank, n_working) * n_total / n_working);
  first_plane_ = first_planes_[rank_];
  n_planes_ = first_planes_[rank_ + 1] - first_plane_;
  if (n_planes_ > 0 && rank_ > 0)
    below_ = rank_ - 1;
  if (n_planes_ > 0 && std::size_t(rank_) + 1 < n_working)
    above_ = rank_ + 1;
}

dealii::Point<3> Slab::position(std::size_t node) const {
  const double i = double(node % row()), j = double(node / row() % grid_.size[1]),
               k = double(node / plane()) + double(first_plane_) - 1.;
  return {grid_.origin[0] + i * grid_.spacing[0], grid_.origin[1] + j * grid_.spacing[1],
          grid_.origin[2] + k * grid_.spacing[2]};
}

bool Slab::on_border(std::size_t node) const {
  const std::size_t i = node % row(), j = node / row() % grid_.size[1],
                    k = node / plane() + first_plane_;
  return i == 0 || i + 1 == grid_.size[0] || j == 0 || j + 1 == grid_.size[1] || k <= 1 ||
         k >= grid_.size[2];
}

void Slab::exchange(NodalField& field) const {
  const int size = int(plane());
  MPI_Sendrecv(field.data() + owned_end() - plane(), size, MPI_FLOAT, above_, 0, field.data(), size,
               MPI_FLOAT, below_, 0, communicator_, MPI_STATUS_IGNORE);
  MPI_Sendrecv(field.data() + owned_begin(), size, MPI_FLOAT, below_, 1, field.data() + owned_end(),
               size, MPI_FLOAT, above_, 1, communicator_, MPI_STATUS_IGNORE);
}

NodalField Slab::gather(const NodalField& field) const {
  NodalField all(grid_.n_voxels());
  std::vector<int> counts(n_ranks_), offsets(n_ranks_);
  for (int rank = 0; rank < n_ranks_; ++rank) {
    offsets[rank] = int(first_planes_[rank] * plane());
    counts[rank] = int((first_planes_[rank + 1] - first_planes_[rank]) * plane());
  }
  MPI_Allgatherv(field.data() + owned_begin(), counts[rank_], MPI_FLOAT, all.data(), counts.data(),
                 offsets.data(), MPI_FLOAT, communicator_);
  return all;
}

} // namespace prosup::fdm
