#ifndef PROSUP_PREPARE_BIAS_FIELD_H
#define PROSUP_PREPARE_BIAS_FIELD_H

#include "prosup/image/voxel_image.h"

namespace prosup::prepare {

/// Divides an MR image by its bias field, the uneven sensitivity of the coil: N4 (Tustison et al.,
/// IEEE Trans. Med. Imaging 29, 2010; implementation of ITK) on voxels of 6 mm, where `body` is not
/// 0 and the intensity is above `threshold`. The field is smooth enough for such voxels; outside it
/// is continued from the nearest of them.
/// @throws Error if no voxel is left.
image::ScalarImage without_bias(const image::ScalarImage& image, const image::LabelImage& body,
                                double threshold);

} // namespace prosup::prepare

#endif
