#ifndef PROSUP_SRC_IMAGE_COMPLETENESS_H
#define PROSUP_SRC_IMAGE_COMPLETENESS_H

#include <itkImageIOBase.h>

#include <filesystem>

namespace prosup::image {

/// Makes sure that a file holds all of its voxels. ITK fills what is missing
/// from a NIfTI or MetaImage file with zeros and reports success. `io` has read
/// the header.
/// @throws Error with the bytes that are there and that should be.
void check_complete(const itk::ImageIOBase& io, const std::filesystem::path& file);

} // namespace prosup::image

#endif
