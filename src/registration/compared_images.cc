#include "compared_images.h"

#include <algorithm>

#include "prosup/image/filters.h"

namespace prosup::registration {

image::ScalarImage smoothed(const image::ScalarImage& image, double level) {
  const auto& spacing = image.grid.spacing;
  const double finest = std::min({spacing[0], spacing[1], spacing[2]});
  return level > 1.5 * finest ? image::gaussian_smooth(image, 0.5 * level) : image;
}

image::ScalarImage tissue_image(const image::LabelImage& labels, unsigned gland_label) {
  image::ScalarImage tissue(labels.grid);
  std::transform(labels.values.begin(), labels.values.end(), tissue.values.begin(),
                 [&](unsigned label) {
                   return label == 0 ? 0.f : label == gland_label ? 1.f : 0.5f;
                 });
  return tissue;
}

} // namespace prosup::registration
