#ifndef PROSUP_PIPELINE_UNLOADED_GRID_H
#define PROSUP_PIPELINE_UNLOADED_GRID_H

#include <vector>

#include "prosup/image/voxel_image.h"
#include "prosup/mesh/tet_mesh.h"

namespace prosup::pipeline {

/// A grid with axes along LPS that holds the unloaded meshes and `margin` mm
/// around them, on multiples of its spacing (mm).
image::VoxelGrid unloaded_grid(const std::vector<const mesh::UnloadedMesh*>& meshes, double spacing,
                               double margin);

} // namespace prosup::pipeline

#endif
