#ifndef PROSUP_SRC_IMAGE_VOXEL_CHECKS_H
#define PROSUP_SRC_IMAGE_VOXEL_CHECKS_H

#include <filesystem>

#include "prosup/image/voxel_image.h"

namespace prosup::image {

/// Physical position of the voxel at `linear_index`, mm.
Point<3> voxel_position(const VoxelGrid& grid, std::size_t linear_index);

/// @throws Error that names `file` and the first place if a value is infinite
/// or not a number.
void check_finite(const ScalarImage& image, const std::filesystem::path& file);
void check_finite(const VectorImage& image, const std::filesystem::path& file);

} // namespace prosup::image

#endif
