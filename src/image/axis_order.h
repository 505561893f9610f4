#ifndef PROSUP_SRC_IMAGE_AXIS_ORDER_H
#define PROSUP_SRC_IMAGE_AXIS_ORDER_H

#include "prosup/image/voxel_image.h"

namespace prosup::image {

/// The same image with its axes in the order left-right, front-back, down-up, as close as they are
/// to these, the last one pointing up and all of them right-handed. Nothing is resampled: a mesh
/// does not depend on the order in which a file happens to hold the voxels.
ScalarImage in_usual_order(ScalarImage image);
LabelImage in_usual_order(LabelImage labels);

} // namespace prosup::image

#endif
