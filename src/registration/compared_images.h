#ifndef PROSUP_REGISTRATION_COMPARED_IMAGES_H
#define PROSUP_REGISTRATION_COMPARED_IMAGES_H

#include "prosup/image/voxel_image.h"

namespace prosup::registration {

/// An image smoothed for voxels of edge `level` mm: half a voxel of blur per voxel of
/// the coarser grid avoids aliasing.
image::ScalarImage smoothed(const image::ScalarImage& image, double level);

/// Air 0, gland 1, all else 1/2: the chest wall looks like fat, no edge that the tissue
/// could be pulled to.
image::ScalarImage tissue_image(const image::LabelImage& labels, unsigned gland_label);

} // namespace prosup::registration

#endif
