#ifndef PROSUP_SRC_OUTPUT_REPORT_DEFORMATION_H
#define PROSUP_SRC_OUTPUT_REPORT_DEFORMATION_H

#include <filesystem>
#include <string>

#include "prosup/image/voxel_image.h"

namespace prosup::output {

/// Slices of the supine breast in the planes of report_slices(): how its volume has changed since
/// prone, and how far it has moved relative to the chest, with the lines of a grid that was
/// straight in prone. From registration.h5 and the mask of the supine image. HTML.
/// @throws Error if the file is damaged, or the mask is empty.
std::string report_deformation(const std::filesystem::path& registration,
                               const image::LabelImage& supine_mask);

} // namespace prosup::output

#endif
