#ifndef PROSUP_PREPARE_CONTRAST_H
#define PROSUP_PREPARE_CONTRAST_H

#include <string>
#include <vector>

#include "prosup/image/voxel_image.h"

namespace prosup::prepare {

/// What an image shows, as far as the segmentation has to know it.
enum class Contrast { t1, t1_fat_suppressed, t2, ct };

/// "t1", "t1fs", "t2", "ct", in the order of the enumerators.
const std::vector<std::string>& contrast_names();

/// A name for people, such as "T1, fat suppressed".
std::string describe(Contrast contrast);

/// Whether fat is brighter than gland and muscle.
constexpr bool fat_is_bright(Contrast contrast) {
  return contrast == Contrast::t1 || contrast == Contrast::t2;
}

/// Whether the values are Hounsfield units: no MR image has air at -500 and below. Values below
/// -1100 are padding and do not count.
bool looks_like_ct(const image::ScalarImage& image);

/// Whether any value is below -500, padding included: without one, nothing is air of a CT.
bool has_air_of_ct(const image::ScalarImage& image);

} // namespace prosup::prepare

#endif
