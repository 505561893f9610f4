#ifndef PROSUP_SRC_PREPARE_BOXES_H
#define PROSUP_SRC_PREPARE_BOXES_H

#include "prosup/image/voxel_image.h"

namespace prosup::prepare {

// Morphology with boxes of voxels, which reach `radius` mm from their centres. What lies beyond the
// border of the image changes nothing.

/// Largest intensity in a box around each voxel.
image::ScalarImage local_peak(const image::ScalarImage& image, double radius);

/// The mask (0 and 1) without what is nearer than `radius` to its outside.
image::LabelImage eroded(const image::LabelImage& mask, double radius);

/// The mask with notches filled that are narrower than a box.
image::LabelImage closed(const image::LabelImage& mask, double radius);

/// The mask without parts that are narrower than a box.
image::LabelImage opened(const image::LabelImage& mask, double radius);

} // namespace prosup::prepare

#endif
