#ifndef PROSUP_PHANTOM_GRIDS_H
#define PROSUP_PHANTOM_GRIDS_H

#include "prosup/image/voxel_image.h"
#include "prosup/phantom/phantom_parameters.h"

namespace prosup::phantom {

/// Voxels for the mesher, of about `spacing` mm: their outer faces lie exactly
/// in the cut planes.
image::VoxelGrid meshing_grid(const Geometry& geometry, double spacing);

/// Voxels of the images of a state (0 prone, 1 supine). All centres lie between
/// the cut planes, so that tissue ends at the border of the image only.
/// @throws Error if rotation and crop leave less than a third of the width or
/// length.
image::VoxelGrid image_grid(const PhantomParameters& parameters, unsigned state);

} // namespace prosup::phantom

#endif
