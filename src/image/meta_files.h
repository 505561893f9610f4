#ifndef PROSUP_SRC_IMAGE_META_FILES_H
#define PROSUP_SRC_IMAGE_META_FILES_H

#include <filesystem>
#include <vector>

#include "meta_header.h"

namespace prosup::image {

/// The files with the voxels of the MetaImage `file`, in turn: itself, the one that it names, or
/// one for each slice. `behind` is the text behind the header.
/// @throws Error if there are none, or not as many as the header needs.
std::vector<std::filesystem::path> voxel_files(const MetaHeader& header, const std::string& behind,
                                               const std::filesystem::path& file);

/// The names that "slice%03d.raw 1 47 1" stands for: the number from the first to the last by a
/// step, which is 1 if it is not there; nothing if this is no such pattern.
std::vector<std::string> names_of_pattern(const std::string& text);

} // namespace prosup::image

#endif
