#ifndef PROSUP_IMAGE_IMAGE_FILES_H
#define PROSUP_IMAGE_IMAGE_FILES_H

#include <filesystem>
#include <vector>

namespace prosup::image {

/// The files that hold the image `file`: itself, and those of its voxels if its header names them
/// or it is one of a pair. Only itself if it is no image that can be read.
std::vector<std::filesystem::path> files_of_image(const std::filesystem::path& file);

} // namespace prosup::image

#endif
