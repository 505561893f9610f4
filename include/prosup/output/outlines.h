#ifndef PROSUP_OUTPUT_OUTLINES_H
#define PROSUP_OUTPUT_OUTLINES_H

#include <filesystem>
#include <string>

#include "prosup/image/voxel_image.h"

namespace prosup::output {

/// The labels whose outlines are drawn.
struct OutlinedLabels {
  unsigned chest = 1, fat = 2, gland = 3;
};

/// Writes `<name>_axial.png`, `<name>_sagittal.png` and `<name>_coronal.png`: slices of an image
/// through its breasts, with the outlines of its labels: skin yellow, front of the chest green,
/// gland red. Oriented as write_slices().
/// @throws Error if no voxel has the label of fat or gland, or if a file cannot be written.
void write_outlines(const image::ScalarImage& image, const image::LabelImage& labels,
                    const OutlinedLabels& shown, const std::string& name,
                    const std::filesystem::path& folder);

} // namespace prosup::output

#endif
