#ifndef PROSUP_SRC_IMAGE_SMOOTHING_H
#define PROSUP_SRC_IMAGE_SMOOTHING_H

#include "prosup/image/voxel_image.h"

namespace prosup::image {

/// Gaussian smoothing with one standard deviation (mm, zero: none) per grid
/// axis.
ScalarImage smooth_along_axes(const ScalarImage& image, const Tensor<1, 3>& sigma_mm);

} // namespace prosup::image

#endif
