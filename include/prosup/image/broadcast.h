#ifndef PROSUP_IMAGE_BROADCAST_H
#define PROSUP_IMAGE_BROADCAST_H

#include <mpi.h>

#include "prosup/image/rigid_transform.h"
#include "prosup/image/voxel_image.h"

namespace prosup::image {

/// Copies the image of rank 0 to all ranks of the communicator.
void broadcast(ScalarImage& image, MPI_Comm communicator);
void broadcast(LabelImage& image, MPI_Comm communicator);

/// Copies the transform of rank 0 to all ranks of the communicator.
void broadcast(RigidTransform& transform, MPI_Comm communicator);

} // namespace prosup::image

#endif
