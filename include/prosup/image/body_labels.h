#ifndef PROSUP_IMAGE_BODY_LABELS_H
#define PROSUP_IMAGE_BODY_LABELS_H

#include <optional>
#include <vector>

#include "prosup/image/voxel_image.h"

namespace prosup::image {

// What the labels of a breast leave unsaid about the rest of the body.

/// Labels the inside of the chest as chest: many masks know only its front, a sheath of muscle with
/// 0 behind it. Voxels of 0 that lie behind a voxel of `chest_label` (posterior, +y in LPS, along
/// the axis of the voxels that is nearest to y) become `chest_label`, up to the next other label;
/// and those behind tissue in a hole of the sheath, 12 mm from its rim at most. `n_filled` is their
/// number.
LabelImage with_inside_of_chest(const LabelImage& labels, unsigned chest_label,
                                std::size_t* n_filled = nullptr);

/// An end of the labelled body in a plane of voxel faces inside the image.
struct FlatEnd {
  unsigned axis = 0;      ///< of the grid
  bool is_upper = false;  ///< whether the body lies at smaller indices
  std::size_t border = 0; ///< index of the voxels above the plane
  double area = 0.;       ///< of tissue in it, mm^2
};

/// Where the body does not end by its own shape but because the mask does: air follows all at once
/// on an area in one plane of voxel faces which no curved skin shows.
std::vector<FlatEnd> flat_ends(const LabelImage& labels, unsigned chest_label);

/// The part of the image up to these ends, which then lie in its border.
LabelImage cropped_to(const LabelImage& labels, const std::vector<FlatEnd>& ends);

/// Tissue that hangs on the body by a thin neck.
struct HangingParts {
  double volume = 0.; ///< mm^3
  Point<3> centre;    ///< of all of them, LPS mm
};

/// Labels such tissue 0: noise, ghosts and coil beside a body that a mask took for tissue. These
/// are the parts of the body (all labels but 0) that an erosion by 3 mm divides from its largest
/// part. Parts of more than 5 % of the tissue are kept, and so is what an erosion removes
/// altogether. Necks are looked for on voxels of about 2 mm. Nothing if there are no such parts.
std::optional<HangingParts> take_off_hanging_parts(LabelImage& labels, unsigned chest_label);

} // namespace prosup::image

#endif
