#ifndef PROSUP_SRC_PREPARE_FLOOD_H
#define PROSUP_SRC_PREPARE_FLOOD_H

#include "prosup/image/voxel_image.h"

namespace prosup::prepare {

/// Extends the region `reached` (not 0) over face neighbours where `passable` is not 0, along paths
/// of at most `depth_mm` from the region that is given.
void flood(image::LabelImage& reached, const image::LabelImage& passable, double depth_mm);

/// Whether the first index of axis 1 of the grid is the front (-y).
bool front_is_first(const image::VoxelGrid& grid);

/// 1 where a straight line from the front face of the image meets nothing that is not `passable`.
image::LabelImage seen_from_front(const image::LabelImage& passable);

} // namespace prosup::prepare

#endif
