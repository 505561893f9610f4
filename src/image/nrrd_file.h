#ifndef PROSUP_SRC_IMAGE_NRRD_FILE_H
#define PROSUP_SRC_IMAGE_NRRD_FILE_H

#include <itkImageBase.h>

#include <filesystem>
#include <optional>

#include "nrrd_header.h"

namespace prosup::image {

/// The header of an NRRD file, `.nrrd` or `.nhdr`. @throws Error as parse_nrrd_header().
NrrdHeader read_nrrd_header(const std::filesystem::path& file);

/// Checks an NRRD file before ITK reads it, which takes LAS for RPS, ignores units and allocates
/// memory for voxels that are not there.
/// @returns where its voxels are, if it says so.
/// @throws Error if its header cannot be used or its data are missing or too short.
std::optional<NrrdPlace> check_nrrd(const std::filesystem::path& file, Remarks& remarks);

/// Moves an image to `place`, if there is one.
void put(const std::optional<NrrdPlace>& place, itk::ImageBase<3>& image);

} // namespace prosup::image

#endif
