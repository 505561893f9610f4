#include "outlines.h"

#include <algorithm>

#include "prosup/image/filters.h"

namespace prosup::registration {

double quantile(std::vector<double> values, double part) {
  if (values.empty())
    return 0.;
  const auto at = values.begin() +
                  static_cast<std::ptrdiff_t>(part * static_cast<double>(values.size() - 1) + 0.5);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

image::ScalarImage distance_to(const image::LabelImage& mask) {
  const bool inside = std::any_of(mask.values.begin(), mask.values.end(),
                                  [](unsigned value) { return value != 0; });
  const bool outside = std::any_of(mask.values.begin(), mask.values.end(),
                                   [](unsigned value) { return value == 0; });
  return inside && outside ? image::signed_distance(mask) : image::ScalarImage();
}

} // namespace prosup::registration
