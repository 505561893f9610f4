#ifndef PROSUP_SRC_IMAGE_NIFTI_GRID_H
#define PROSUP_SRC_IMAGE_NIFTI_GRID_H

#include <string>

#include "nifti_header.h"
#include "prosup/core/remarks.h"
#include "prosup/image/image_io.h"

namespace prosup::image {

/// Where the voxels of a NIfTI file are, LPS, mm: by its sform, or by its qform if it has no sform
/// that can be used, with `transform` where they disagree. What is doubtful goes to `remarks`.
/// @throws Error that names `file` if the position is not known, or not for sure.
VoxelGrid nifti_grid(const NiftiHeader& header, NiftiTransform transform, const std::string& file,
                     Remarks& remarks);

} // namespace prosup::image

#endif
