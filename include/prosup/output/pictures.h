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

/// An image, and the intensities that are shown as black and as white. Keeps a pointer to the
/// image.
struct ShownImage {
  const image::ScalarImage* image = nullptr;
  image::IntensityRange window;
};

/// One panel of a picture: an image in grey or, with `subtract`, the difference of the two windowed
/// images in blue (negative), white and red (positive).
struct Panel {
  std::string title;
  ShownImage shown;
  std::optional<ShownImage> subtract;
};

/// The region that is shown (LPS, mm), and the point through which the slices pass.
struct SliceBox {
  Point<3> low, high, centre;
};

/// A box around the non-zero voxels of the masks with a margin, cut off at the fields of view of
/// the masks. Its centre is the mean of the masks' centres of mass.
/// @throws Error if a mask is empty.
SliceBox slice_box(const std::vector<const image::LabelImage*>& masks);

/// Writes `slices_axial.png`, `slices_sagittal.png` and `slices_coronal.png`, each with all panels
/// in rows. Works without a display. The orientation is the radiological one: the patient's left is
/// on the right in axial and coronal slices, anterior is on the left in sagittal ones, and anterior
/// or superior is up. Pixels are square and of the same size in all panels; pictures are 1500
/// pixels wide. All differences in a picture have the same scale, which is given in their titles.
/// @throws Error if a file cannot be written.
void write_slices(const std::vector<std::vector<Panel>>& rows, const SliceBox& box,
                  const std::filesystem::path& folder);

/// The images of a registration. Masks are non-zero in the breast.
struct RegistrationImages {
  const image::ScalarImage &prone, &supine;
  const image::LabelImage &prone_mask, &supine_mask;
  const image::ScalarImage &unloaded_prone, &unloaded_supine;
};

/// Writes slices of the prone image, the supine image and their difference, and below them those of
/// the unloaded images.
/// @throws Error as write_slices(), slice_box() and image::robust_range().
void write_registration_slices(const RegistrationImages& images,
                               const std::filesystem::path& folder);

/// Writes slices of an unloaded image, with its mask, beside those of the loaded image.
void write_loading_slices(const image::ScalarImage& unloaded, const image::LabelImage& mask,
                          const image::ScalarImage& loaded, const std::filesystem::path& folder);

/// Writes slices of a loaded image, with its mask, beside those of the unloaded image.
void write_unloading_slices(const image::ScalarImage& loaded, const image::LabelImage& mask,
                            const image::ScalarImage& unloaded,
                            const std::filesystem::path& folder);

} // namespace prosup::output

#endif
