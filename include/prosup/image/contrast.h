#ifndef PROSUP_IMAGE_CONTRAST_H
#define PROSUP_IMAGE_CONTRAST_H

#include "prosup/image/voxel_image.h"

namespace prosup::image {

/// Median intensity of the voxels with a label.
/// @throws Error if there are none, or if the sizes differ.
float median_intensity(const ScalarImage& image, const LabelImage& labels, unsigned label);

/// What a breast consists of for an imaging modality.
struct TissueIntensities {
  double air = 0.;
  double fat = 0.;
  double gland = 0.;
};

/// The image as one of another modality would show it: the paper's "intensity
/// inversion with a linear scaling", fat to fat and gland to gland,
///   I' = to.fat + (I - from.fat) (to.gland - to.fat)/(from.gland - from.fat).
/// In air the line through air and fat is taken, and halfway between both in the
/// voxels next to it, part of which is air: the line of the tissues alone would
/// make a bright rim of a fading one, that of the outline would take away the
/// skin, which is rather gland than fat. Clamps to
/// `rescaled_range`. `labels` are zero in air.
/// @throws Error if fat has the intensity of gland or air in `from`.
ScalarImage convert_contrast(const ScalarImage& image, const LabelImage& labels,
                             const TissueIntensities& from, const TissueIntensities& to);

} // namespace prosup::image

#endif
