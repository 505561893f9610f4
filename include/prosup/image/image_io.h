#ifndef PROSUP_IMAGE_IMAGE_IO_H
#define PROSUP_IMAGE_IMAGE_IO_H

#include <filesystem>
#include <string>

#include "prosup/image/voxel_image.h"

namespace prosup::image {

// Formats: NIfTI (.nii, .nii.gz), NRRD (.nrrd, .nhdr), MetaImage (.mha, .mhd).
// Origin, spacing and direction cosines are honoured; coordinates are LPS, mm.

/// Reads a three-dimensional image of any scalar pixel type.
/// @throws Error if the file is missing, of another format, damaged, not
/// three-dimensional, not scalar, has a spacing that is not positive or axes
/// that are not at right angles, or holds values that are not finite.
ScalarImage read_image(const std::filesystem::path& file);

/// Reads a label image; its values must be integers from 0 to 255.
/// @throws Error as read_image(), or if a value is no label.
LabelImage read_labels(const std::filesystem::path& file);

/// Reads a displacement field (three components per voxel; LPS, mm) from NRRD
/// or MetaImage.
/// @throws Error as read_image().
VectorImage read_displacement(const std::filesystem::path& file);

/// Writes `image`, compressed, in the format the file name asks for.
/// @throws Error if the format is unknown, a value is not finite, or the file
/// cannot be written.
void write_image(const ScalarImage& image, const std::filesystem::path& file);
void write_labels(const LabelImage& image, const std::filesystem::path& file);

/// Writes displacements as ITK and 3D Slicer expect them of a displacement
/// field transform. NIfTI is refused: its vector fields are read differently by
/// different tools.
/// @throws Error as write_image().
void write_displacement(const VectorImage& field, const std::filesystem::path& file);

/// Makes sure that labels lie on the voxels of their image.
/// @throws Error that names both files and where they differ (size, spacing,
/// direction, origin) with both values.
void check_labels_fit(const ScalarImage& image, const LabelImage& labels,
                      const std::string& image_name, const std::string& labels_name);

/// Makes sure that `label`, which stands for `what`, occurs.
/// @throws Error that names the file and the labels that do occur.
void require_label(const LabelImage& labels, unsigned label, const std::string& what,
                   const std::string& file);

} // namespace prosup::image

#endif
