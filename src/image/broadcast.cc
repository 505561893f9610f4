#include "prosup/image/broadcast.h"

#include "prosup/core/error.h"

namespace prosup::image {

namespace {

constexpr std::size_t most_voxels = 2000000000; // what an MPI count can hold

template <typename T>
void broadcast_image(VoxelImage<T>& image, MPI_Datatype type, MPI_Comm communicator) {
  double geometry[15];
  VoxelGrid& grid = image.grid;
  for (unsigned d = 0; d < 3; ++d) {
    geometry[d] = grid.origin[d];
    geometry[3 + d] = grid.spacing[d];
    for (unsigned e = 0; e < 3; ++e)
      geometry[6 + 3 * d + e] = grid.direction[d][e];
  }
  unsigned long size[3] = {grid.size[0], grid.size[1], grid.size[2]};
  MPI_Bcast(geometry, 15, MPI_DOUBLE, 0, communicator);
  MPI_Bcast(size, 3, MPI_UNSIGNED_LONG, 0, communicator);
  for (unsigned d = 0; d < 3; ++d) {
    grid.size[d] = size[d];
    grid.origin[d] = geometry[d];
    grid.spacing[d] = geometry[3 + d];
    for (unsigned e = 0; e < 3; ++e)
      grid.direction[d][e] = geometry[6 + 3 * d + e];
  }
  if (grid.n_voxels() > most_voxels)
    throw Error("An image has more than 2e9 voxels; resample it to a coarser grid first.");
  image.values.resize(grid.n_voxels());
  MPI_Bcast(image.values.data(), static_cast<int>(image.values.size()), type, 0, communicator);
}

} // namespace

void broadcast(ScalarImage& image, MPI_Comm communicator) {
  broadcast_image(image, MPI_FLOAT, communicator);
}

void broadcast(LabelImage& image, MPI_Comm communicator) {
  broadcast_image(image, MPI_UINT8_T, communicator);
}

void broadcast(RigidTransform& transform, MPI_Comm communicator) {
  for (unsigned row = 0; row < 3; ++row)
    MPI_Bcast(transform.rotation[row].begin_raw(), 3, MPI_DOUBLE, 0, communicator);
  MPI_Bcast(transform.centre.begin_raw(), 3, MPI_DOUBLE, 0, communicator);
  MPI_Bcast(transform.translation.begin_raw(), 3, MPI_DOUBLE, 0, communicator);
}

} // namespace prosup::image
