#ifndef PROSUP_OUTPUT_PICTURES_H
#define PROSUP_OUTPUT_PICTURES_H

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "prosup/image/filters.h"
#include "prosup/image/voxel_image.h"

namespace prosup::output {

using dealii::Point;

/// An image and the intensities that are shown black and white. Keeps a pointer.
struct ShownImage {
  const image::ScalarImage* image = nullptr;
  image::IntensityRange window;
};

/// One part of a picture: an image in grey, or, with `subtract`, the difference
/// of both windowed images in blue (negative), white and red (positive).
struct Panel {
  std::string title;
  ShownImage shown;
  std::optional<ShownImage> subtract;
};

/// The box of physical space (LPS, mm) that is shown, and the point through
/// which the slices go.
struct SliceBox {
  Point<3> low, high, centre;
};

/// A box around what is not zero in the masks, with some surroundings as far as
/// one of the masks' fields of view goes; its centre is the mean of the masks'
/// centres of mass.
/// @throws Error if a mask is empty.
SliceBox slice_box(const std::vector<const image::LabelImage*>& masks);

/// Writes `slices_axial.png`, `slices_sagittal.png` and `slices_coronal.png`,
/// each with all panels in their rows, and no display needed. Orientation is the
/// radiologist's: axial and coronal slices have the patient's left at the right,
/// sagittal ones anterior at the left; anterior or superior is up. Pixels are
/// square and the same for all panels; a picture is 1500 pixels wide. Differences
/// in one picture share their scale, which the titles give.
/// @throws Error if a file cannot be written.
void write_slices(const std::vector<std::vector<Panel>>& rows, const SliceBox& box,
                  const std::filesystem::path& folder);

/// The images of a registration; masks are not zero in the breast.
struct RegistrationImages {
  const image::ScalarImage &prone, &supine;
  const image::LabelImage &prone_mask, &supine_mask;
  const image::ScalarImage &unloaded_prone, &unloaded_supine;
};

/// Slices of prone, supine and their difference, above those of the unloaded
/// images. @throws Error as write_slices(), slice_box() and image::robust_range().
void write_registration_slices(const RegistrationImages& images,
                               const std::filesystem::path& folder);

/// Slices of an unloaded image, whose mask is given, beside its loaded one.
void write_loading_slices(const image::ScalarImage& unloaded, const image::LabelImage& mask,
                          const image::ScalarImage& loaded, const std::filesystem::path& folder);

/// Slices of a loaded image, whose mask is given, beside its unloaded one.
void write_unloading_slices(const image::ScalarImage& loaded, const image::LabelImage& mask,
                            const image::ScalarImage& unloaded,
                            const std::filesystem::path& folder);

} // namespace prosup::output

#endif
