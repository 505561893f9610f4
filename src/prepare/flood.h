#ifndef PROSUP_SRC_PREPARE_FLOOD_H
#define PROSUP_SRC_PREPARE_FLOOD_H

#include "prosup/image/voxel_image.h"

namespace prosup::prepare {

/// Extends the region `reached` (not 0) over face neighbours where `passable` is not 0, along paths
/// of at most `depth_mm` from the region that is given.
void flood(image::LabelImage& reached, const image::LabelImage& passable, double depth_mm);

} // namespace prosup::prepare

#endif
