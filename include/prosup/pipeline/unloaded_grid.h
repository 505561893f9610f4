#ifndef PROSUP_PIPELINE_UNLOADED_GRID_H
#define PROSUP_PIPELINE_UNLOADED_GRID_H

#include <vector>

#include "prosup/image/voxel_image.h"
#include "prosup/mesh/tet_mesh.h"

namespace prosup::pipeline {

/// A grid with axes along LPS that contains the unloaded meshes with a margin. `spacing` and
/// `margin` are in mm; the origin is a multiple of the spacing.
image::VoxelGrid unloaded_grid(const std::vector<const mesh::UnloadedMesh*>& meshes, double spacing,
                               double margin);

} // namespace prosup::pipeline

#endif
