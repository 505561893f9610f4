#include "prosup/registration/completed_labels.h"

#include "prosup/image/body_labels.h"

namespace prosup::registration {

image::LabelImage completed_labels(const image::LabelImage& given, Position position,
                                   unsigned chest_label, const Log& log,
                                   std::vector<std::string>& remarks) {
  std::size_t n_filled = 0;
  const image::LabelImage labels = image::with_inside_of_chest(given, chest_label, &n_filled);
  if (n_filled > 0)
    log.line(format("  %s: %.3g ml of air behind the chest label taken for chest",
                    name_of(position), 1e-3 * double(n_filled) * given.grid.voxel_volume()));
  const std::vector<image::FlatEnd> ends = image::flat_ends(labels, chest_label);
  for (const image::FlatEnd& end : ends) {
    dealii::Tensor<1, 3> outwards;
    for (unsigned c = 0; c < 3; ++c)
      outwards[c] = (end.is_upper ? 1. : -1.) * given.grid.direction[c][end.axis];
    remarks.push_back(format(
        "The mask of the %s breast ends flat inside the image, on %.0f mm2 facing (%.2g, %.2g, "
        "%.2g); this was taken for a cut plane, not for skin, so label what lies beyond it, or "
        "crop the image there.",
        name_of(position), end.area, outwards[0], outwards[1], outwards[2]));
  }
  return ends.empty() ? labels : image::cropped_to(labels, ends);
}

} // namespace prosup::registration
