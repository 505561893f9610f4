#ifndef PROSUP_SRC_IMAGE_VOXEL_CHECKS_H
#define PROSUP_SRC_IMAGE_VOXEL_CHECKS_H

#include <filesystem>

#include "prosup/core/remarks.h"
#include "prosup/image/voxel_image.h"

namespace prosup::image {

/// Physical position of the voxel at `linear_index`, mm.
Point<3> voxel_position(const VoxelGrid& grid, std::size_t linear_index);

/// @throws Error that names `file` and the first place if a value is infinite
/// or not a number.
void check_finite(const ScalarImage& image, const std::filesystem::path& file);
void check_finite(const VectorImage& image, const std::filesystem::path& file);

/// Values as labels. `step` is the difference between values that `file` holds as neighbouring
/// integers, or 0; what was rounded because of it goes to `remarks`.
/// @throws Error that names `file` and the first place if a value is no integer from 0 to 255.
LabelImage rounded_labels(const ScalarImage& values, double step, const std::filesystem::path& file,
                          Remarks& remarks);

/// @throws Error if there are more voxels than prosup can hold.
void check_size(const std::array<std::size_t, 3>& size, const std::filesystem::path& file);

} // namespace prosup::image

#endif
