#ifndef PROSUP_REGISTRATION_COMPLETED_LABELS_H
#define PROSUP_REGISTRATION_COMPLETED_LABELS_H

#include <string>
#include <vector>

#include "prosup/core/log.h"
#include "prosup/core/position.h"
#include "prosup/image/voxel_image.h"

namespace prosup::registration {

/// The labels from which a breast is meshed: air behind a sheath of chest muscle is chest
/// (image::with_inside_of_chest()), what hangs on a thin neck is air
/// (image::take_off_hanging_parts()), and the image ends where the mask ends flat inside it
/// (image::flat_ends()), so that there is a cut plane and no skin. Tells `log` of the first, and
/// adds sentences to `remarks` for the others. What is `unknown_label`, if that is not 0, stays,
/// and tissue that ends there is no flat end: it is cut there already.
image::LabelImage completed_labels(const image::LabelImage& given, Position position,
                                   unsigned chest_label, unsigned unknown_label, const Log& log,
                                   std::vector<std::string>& remarks);

} // namespace prosup::registration

#endif
