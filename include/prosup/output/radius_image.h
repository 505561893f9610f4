#ifndef PROSUP_OUTPUT_RADIUS_IMAGE_H
#define PROSUP_OUTPUT_RADIUS_IMAGE_H

#include "prosup/evaluation/error_bar.h"
#include "prosup/image/voxel_image.h"

namespace prosup::output {

/// The radius that holds the truth with 95 % (evaluation::error_bar()), mm, on a grid of the
/// unloaded configuration: the root mean square of both meshes where both are, 0 outside of them.
image::ScalarImage radius_image(const image::VoxelGrid& grid,
                                const PerPosition<mesh::UnloadedMesh>& meshes,
                                const evaluation::Uncertainty::Covariances& covariances);

} // namespace prosup::output

#endif
