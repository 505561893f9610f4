#ifndef PROSUP_IMAGE_IMAGE_IO_H
#define PROSUP_IMAGE_IMAGE_IO_H

#include <filesystem>
#include <string>

#include "prosup/core/remarks.h"
#include "prosup/image/voxel_image.h"

namespace prosup::image {

// Formats: NIfTI (.nii, .nii.gz), NRRD (.nrrd, .nhdr), MetaImage (.mha, .mhd).
// Origin, spacing and direction cosines are used; coordinates are LPS, mm.

// What is doubtful in a file goes to `remarks`, or is not told if none are given.

/// Which of the two transforms of a NIfTI header places the voxels if it has both, and they differ
/// by more than a tenth of a voxel somewhere in the image.
enum class NiftiTransform { must_agree, sform, qform };

/// Reads a 3D image of any scalar type; its axes become left-right, front-back, down-up.
/// @throws Error if the file is missing or damaged or has another format, if the image is not
/// three-dimensional or not scalar, if a spacing is not positive or the axes are not at right
/// angles, or if a value is not finite.
ScalarImage read_image(const std::filesystem::path& file, Remarks& remarks,
                       NiftiTransform transform = NiftiTransform::must_agree);
ScalarImage read_image(const std::filesystem::path& file);

/// Reads a label image; its values must be integers from 0 to 255.
/// @throws Error as read_image(), or if a value is not such an integer.
LabelImage read_labels(const std::filesystem::path& file, Remarks& remarks,
                       NiftiTransform transform = NiftiTransform::must_agree);
LabelImage read_labels(const std::filesystem::path& file);

/// Reads a displacement field (three components per voxel; LPS, mm) from NRRD
/// or MetaImage.
/// @throws Error as read_image().
VectorImage read_displacement(const std::filesystem::path& file);

/// Writes an image, compressed, in the format given by the extension of the file name.
/// @throws Error if the format is unknown, a value is not finite, or the file
/// cannot be written.
void write_image(const ScalarImage& image, const std::filesystem::path& file);
void write_labels(const LabelImage& image, const std::filesystem::path& file);

/// Writes a displacement field that ITK and 3D Slicer read as a displacement field transform.
/// @throws Error as write_image(), and for NIfTI, since tools disagree about the coordinates
/// of its vector fields.
void write_displacement(const VectorImage& field, const std::filesystem::path& file);

/// Labels on the voxels of their image. If they lie on those but for rounding of headers (a tenth
/// of a voxel), they get its grid; if their grid is another one with parallel axes, such as a
/// cropped, coarser or finer one, they are resampled by the nearest voxel, which `remarks` are
/// told.
/// @throws Error that names both files and where they differ (size, spacing, direction, origin)
/// with both values, if there are as many voxels in another place, if the axes are not parallel, or
/// if less than half of the labels lie within the image.
LabelImage fit_labels(LabelImage labels, const ScalarImage& image, const std::string& labels_name,
                      const std::string& image_name, Remarks& remarks);

/// Whether the values of an image mark regions, however many: integers from 0 to 255, of which
/// there are few, or which most voxels share with their neighbours.
bool marks_regions(const ScalarImage& image);

/// Checks that the values mark regions, however many, instead of being intensities.
/// @throws Error that names the file.
void require_regions(const LabelImage& labels, const std::string& file);

/// Checks that at least one voxel has `label`, which means `what`.
/// @throws Error that names the file and the labels that it has.
void require_label(const LabelImage& labels, unsigned label, const std::string& what,
                   const std::string& file);

} // namespace prosup::image

#endif
