#ifndef PROSUP_IMAGE_CONTRAST_H
#define PROSUP_IMAGE_CONTRAST_H

#include "prosup/image/voxel_image.h"

namespace prosup::image {

/// Median intensity of the voxels with a label.
/// @throws Error if no voxel has it, or if the sizes differ.
float median_intensity(const ScalarImage& image, const LabelImage& labels, unsigned label);

/// Typical intensities of an imaging modality.
struct TissueIntensities {
  double air = 0.;
  double fat = 0.;
  double gland = 0.;
};

/// Converts an image to the contrast of another modality, by the paper's "intensity
/// inversion with a linear scaling" of Fig. 4. Tissue is mapped by the line through fat and
/// gland,
///   I' = to.fat + (I - from.fat) (to.gland - to.fat)/(from.gland - from.fat),
/// and air, where `labels` are 0, by the line through air and fat. Voxels of tissue next to
/// air are partly air and get the mean of both: with the first line alone a dark rim would
/// become bright, and with the second alone the skin, which looks like gland, would vanish.
/// Results are clamped to `rescaled_range`.
/// @throws Error if fat has the intensity of gland or air in `from`.
ScalarImage convert_contrast(const ScalarImage& image, const LabelImage& labels,
                             const TissueIntensities& from, const TissueIntensities& to);

} // namespace prosup::image

#endif
