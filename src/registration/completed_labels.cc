#include "prosup/registration/completed_labels.h"

#include <algorithm>
#include <optional>

#include "prosup/image/body_labels.h"

namespace prosup::registration {

namespace {

bool has(const image::LabelImage& labels, unsigned label) {
  return label != 0 &&
         std::find(labels.values.begin(), labels.values.end(), label) != labels.values.end();
}

/// With another label where nothing is known.
image::LabelImage with_unknown_as(std::uint8_t label, image::LabelImage labels,
                                  unsigned unknown_label) {
  std::replace(labels.values.begin(), labels.values.end(), std::uint8_t(unknown_label), label);
  return labels;
}

/// image::take_off_hanging_parts() for the body; what is unknown is none of its parts.
std::optional<image::HangingParts>
take_off_hanging_parts(image::LabelImage& labels, unsigned chest_label, unsigned unknown_label) {
  if (!has(labels, unknown_label))
    return image::take_off_hanging_parts(labels, chest_label);
  image::LabelImage body = with_unknown_as(0, labels, unknown_label);
  const auto parts = image::take_off_hanging_parts(body, chest_label);
  for (std::size_t v = 0; parts && v < body.values.size(); ++v)
    if (labels.values[v] != unknown_label)
      labels.values[v] = body.values[v];
  return parts;
}

/// image::flat_ends() but for those at what is unknown.
std::vector<image::FlatEnd> flat_ends(const image::LabelImage& labels, unsigned chest_label,
                                      unsigned unknown_label) {
  if (!has(labels, unknown_label))
    return image::flat_ends(labels, chest_label);
  return image::flat_ends(with_unknown_as(std::uint8_t(chest_label), labels, unknown_label),
                          chest_label);
}

} // namespace

image::LabelImage completed_labels(const image::LabelImage& given, Position position,
                                   unsigned chest_label, unsigned unknown_label, const Log& log,
                                   std::vector<std::string>& remarks) {
  std::size_t n_filled = 0;
  image::LabelImage labels = image::with_inside_of_chest(given, chest_label, &n_filled);
  if (n_filled > 0)
    log.line(format("  %s: %.3g ml of air behind the chest label taken for chest",
                    name_of(position), 1e-3 * double(n_filled) * given.grid.voxel_volume()));
  if (const auto parts = take_off_hanging_parts(labels, chest_label, unknown_label))
    remarks.push_back(format(
        "%.3g ml of the mask of the %s breast, around (%.0f, %.0f, %.0f) mm, hang on necks thinner "
        "than 6 mm; they were left out as noise or a fold beside the body, so look there, and "
        "label "
        "them 0, or more of the tissue between.",
        1e-3 * parts->volume, name_of(position), parts->centre[0], parts->centre[1],
        parts->centre[2]));
  const std::vector<image::FlatEnd> ends = flat_ends(labels, chest_label, unknown_label);
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
