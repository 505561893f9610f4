#ifndef PROSUP_SRC_IMAGE_NIFTI_TRANSFORMS_H
#define PROSUP_SRC_IMAGE_NIFTI_TRANSFORMS_H

#include <optional>

#include "nifti_header.h"
#include "regular_grid.h"

namespace prosup::image {

/// Whether `size` can be the length of a voxel, or minus that.
bool is_size(double size);

// The transforms of a NIfTI header from voxels to LPS, mm, or nothing if the header has none whose
// numbers are a transform.

/// Method 2 of the standard: turned by a quaternion, with voxels of the header's voxel size.
std::optional<VoxelSteps> qform(const NiftiHeader& header);

/// Method 3 of the standard: a matrix, which may shear.
std::optional<VoxelSteps> sform(const NiftiHeader& header);

/// How far two places of voxels are apart at the corners of the image, and thus within it.
struct Distance {
  double voxels = 0.; ///< along the axis where it is largest
  double mm = 0.;
};
Distance distance(const VoxelSteps& place, const VoxelGrid& from);

} // namespace prosup::image

#endif
