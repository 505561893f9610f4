#ifndef PROSUP_SRC_IMAGE_NRRD_FILE_H
#define PROSUP_SRC_IMAGE_NRRD_FILE_H

#include <filesystem>

#include "nrrd_header.h"

namespace prosup::image {

/// The header of an NRRD file, `.nrrd` or `.nhdr`. @throws Error as parse_nrrd_header().
NrrdHeader read_nrrd_header(const std::filesystem::path& file);

} // namespace prosup::image

#endif
