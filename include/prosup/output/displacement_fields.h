#ifndef PROSUP_OUTPUT_DISPLACEMENT_FIELDS_H
#define PROSUP_OUTPUT_DISPLACEMENT_FIELDS_H

#include "prosup/evaluation/point_mapper.h"
#include "prosup/image/voxel_image.h"
#include "prosup/mesh/tet_mesh.h"

namespace prosup::output {

// Displacement fields in ITK's convention: the value at a grid point is the displacement of that
// point, in mm (LPS). In the mesh it is that of the linear elements. In a few layers of voxels
// around the mesh it is that of the closest point on the surface, and beyond them that of the
// nearest voxel in these layers. The fields are finite and continuous everywhere.

/// u = x - X on a grid of the unloaded configuration.
/// @throws Error if no voxel centre is in the mesh.
image::VectorImage unloaded_to_loaded(const image::VoxelGrid& grid, const mesh::UnloadedMesh& mesh,
                                      const evaluation::PointMapper& mapper);

/// Displacement from one loaded configuration to the other, through the unloaded one:
/// x_to(X(x_from)) - x_from on a grid of the loaded configuration of `from`.
/// @throws Error if no voxel centre is in the mesh.
image::VectorImage loaded_to_loaded(const image::VoxelGrid& grid, const mesh::UnloadedMesh& from,
                                    const evaluation::PointMapper& from_mapper,
                                    const evaluation::PointMapper& to_mapper);

} // namespace prosup::output

#endif
