#ifndef PROSUP_PREPARE_UNKNOWN_REGION_H
#define PROSUP_PREPARE_UNKNOWN_REGION_H

#include <optional>

#include "prosup/image/voxel_image.h"

namespace prosup::prepare {

/// What a scan does not show although its voxels reach there: beyond the reconstruction circle of
/// CT, or beyond the edge that the correction of gradients leaves in MR.
struct UnknownRegion {
  image::LabelImage mask; ///< 1 in it
  double value = 0.;      ///< of all its voxels
  double contact = 0.;    ///< cm^2 of its border are tissue, not air
};

/// The voxels of exactly the smallest value of the scan, without parts that are thinner than 4 mm,
/// as far as they hang together with the border of the image, if they touch tissue on 2 cm^2 or
/// more: skin has a blurred edge and noise in the air before it. Air that has this value all over
/// (90 % of what is no tissue) is air. `body` is not 0 in the body and in what is not seen from the
/// front.
std::optional<UnknownRegion> find_unknown(const image::ScalarImage& scan,
                                          const image::LabelImage& body);

} // namespace prosup::prepare

#endif
