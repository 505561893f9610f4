#include "outlines.h"

#include <algorithm>

#include "prosup/image/filters.h"

namespace prosup::registration {

image::ScalarImage distance_to(const image::LabelImage& mask) {
  const bool inside = std::any_of(mask.values.begin(), mask.values.end(),
                                  [](unsigned value) { return value != 0; });
  const bool outside = std::any_of(mask.values.begin(), mask.values.end(),
                                   [](unsigned value) { return value == 0; });
  return inside && outside ? image::signed_distance(mask) : image::ScalarImage();
}

} // namespace prosup::registration
