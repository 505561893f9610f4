#ifndef PROSUP_PHANTOM_GRIDS_H
#define PROSUP_PHANTOM_GRIDS_H

#include "prosup/image/voxel_image.h"
#include "prosup/phantom/phantom_parameters.h"

namespace prosup::phantom {

/// Grid for the labels that are meshed, with voxels of about `spacing` mm. Its border lies
/// exactly in the cut planes.
image::VoxelGrid meshing_grid(const Geometry& geometry, double spacing);

/// Grid of the images of one position. All voxel centres lie between the cut planes, so
/// that tissue ends only at the border of the image.
/// @throws Error if rotation and crop leave less than a third of the width or length.
image::VoxelGrid image_grid(const Geometry& geometry, const ImagingParameters& images,
                            Position position);

} // namespace prosup::phantom

#endif
