#ifndef PROSUP_SRC_IMAGE_NRRD_DATA_H
#define PROSUP_SRC_IMAGE_NRRD_DATA_H

#include <filesystem>
#include <vector>

#include "nrrd_header.h"

namespace prosup::image {

/// The files that hold the voxels; none if these follow the header.
/// @throws Error that names `file` if one of them does not exist.
std::vector<std::filesystem::path> nrrd_data_files(const NrrdHeader& header,
                                                   const std::filesystem::path& file);

/// Checks that the voxels which the header of `file` announces are there, in the file itself or in
/// those that it names. ITK allocates memory for them first.
/// @throws Error that names the file if one is missing, damaged, too short or packed in a way that
/// cannot be read.
void check_nrrd_data(const NrrdHeader& header, const std::filesystem::path& file);

} // namespace prosup::image

#endif
