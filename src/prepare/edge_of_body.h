#ifndef PROSUP_SRC_PREPARE_EDGE_OF_BODY_H
#define PROSUP_SRC_PREPARE_EDGE_OF_BODY_H

#include "prosup/image/voxel_image.h"

namespace prosup::prepare {

/// The body in MR with noise and ghosts beside it, on voxels of 2 mm and 2 mm too large: what a
/// watershed on the gradient of log(I + t/2) gives to the tissue, with t the threshold between
/// noise and tissue. It starts from what is surely air, seen from the front and darker than t, and
/// from what is surely tissue, thick and brighter than 1.5 t and than 0.15 of the largest intensity
/// within 25 mm. Ghosts are brighter than t in places, but the edge of the skin is steeper.
/// (Beucher and Meyer, in: Mathematical Morphology in Image Processing, Dekker, 1993; ITK.)
image::LabelImage body_within_edges(const image::ScalarImage& image, double threshold);

} // namespace prosup::prepare

#endif
