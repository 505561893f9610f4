#ifndef PROSUP_OUTPUT_TRANSFORM_FILE_H
#define PROSUP_OUTPUT_TRANSFORM_FILE_H

#include <filesystem>

#include "prosup/image/voxel_image.h"

namespace prosup::output {

/// Whether the name of a file ends as those of write_transform().
bool is_transform(const std::filesystem::path& file);

/// Writes a displacement field as a transform of ITK in HDF5 (`.h5`): a DisplacementFieldTransform,
/// which takes a point to where the field leads, LPS, mm, and leaves those outside of the grid
/// where they are. It is compressed, in single precision as the field is. For one rank.
/// @throws Error if a number is not finite or the file cannot be written completely.
void write_transform(const image::VectorImage& field, const std::filesystem::path& file);

} // namespace prosup::output

#endif
