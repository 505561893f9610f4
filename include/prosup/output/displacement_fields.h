#ifndef PROSUP_OUTPUT_DISPLACEMENT_FIELDS_H
#define PROSUP_OUTPUT_DISPLACEMENT_FIELDS_H

#include "prosup/evaluation/point_mapper.h"
#include "prosup/image/voxel_image.h"
#include "prosup/mesh/tet_mesh.h"

namespace prosup::output {

// Displacement fields in ITK's convention: the value at a grid point leads from
// there, LPS mm. In the mesh they are those of the linear elements, in a few
// layers of voxels around it those of the closest point of its surface, beyond
// those of the nearest voxel of these layers; so they are finite and without
// jumps everywhere.

/// u = x - X on a grid of the unloaded configuration.
/// @throws Error if no voxel centre lies in the mesh.
image::VectorImage unloaded_to_loaded(const image::VoxelGrid& grid, const mesh::UnloadedMesh& mesh,
                                      const evaluation::PointMapper& mapper);

/// From a loaded state, on whose grid the field is, by the unloaded configuration
/// to the loaded state of the other mesh: x_to(X(x_from)) - x_from.
/// @throws Error if no voxel centre lies in the mesh.
image::VectorImage loaded_to_loaded(const image::VoxelGrid& grid, const mesh::UnloadedMesh& from,
                                    const evaluation::PointMapper& from_mapper,
                                    const evaluation::PointMapper& to_mapper);

} // namespace prosup::output

#endif
