#include <cmath>

#include "prosup/core/log.h"
#include "prosup/core/text.h"
#include "prosup/similarity/similarity_parameters.h"
#include "scene_findings.h"

namespace prosup::registration {

namespace {

// Limits: see the tables in docs/checks.md.
constexpr std::size_t least_values = 10; // intensities of an image in the breast
constexpr double clear_contrast = 0.1;   // of fat and gland, of the scaled range
constexpr double least_histogram = 0.6;  // of the intensities that both have
constexpr double same_gravity = 30.;     // degrees within which two images may be the same

using Maybe = std::optional<Finding>;

Maybe same_files(const PairMeasures& pair) {
  if (pair.gravity_angle < same_gravity || (!pair.same_image && !pair.same_labels))
    return {};
  const char* what = !pair.same_labels  ? "images"
                     : !pair.same_image ? "labels"
                                        : "images and labels";
  return error(format("The prone and the supine %s are the same, voxel by voxel, though gravity "
                      "differs by %.0f degrees; give the files of both positions.",
                      what, pair.gravity_angle));
}

Maybe labels_as_image(const PairMeasures& pair, Position position) {
  const std::size_t n = pair.n_values[position];
  if (n >= least_values)
    return {};
  return error(format("The %s image has only %zu different intensities in the breast, as a mask "
                      "has; give the image that the mask was drawn on.",
                      name_of(position), n));
}

Maybe unfit_contrast(const PairMeasures& pair) {
  const std::string advice = "use '--similarity " +
                             joined(similarity::metric_names(true), "' or '--similarity ") +
                             "', or set 'Images/Contrast'.";
  const auto& [prone, supine] = pair.contrast;
  if (prone && supine) {
    const double a = prone->gland - prone->fat, b = supine->gland - supine->fat;
    if (a * b < 0. && std::abs(a) > clear_contrast && std::abs(b) > clear_contrast)
      return warning(
          format("Gland is %s than fat in the prone image and %s in the supine one, which "
                 "a metric of differences cannot compare; %s",
                 a < 0. ? "darker" : "brighter", b < 0. ? "darker" : "brighter", advice.c_str()));
  }
  if (pair.common_histogram < least_histogram)
    return warning(format("Only %.0f %% of the intensities in the two breasts agree, as if the "
                          "images were of different kinds; %s",
                          100. * pair.common_histogram, advice.c_str()));
  return {};
}

} // namespace

Findings image_findings_of(const PairMeasures& pair, const SceneOptions& options) {
  Findings result;
  const auto add = [&](const Maybe& found) {
    if (found)
      result.push_back(*found);
  };
  add(same_files(pair));
  for (const Position position : both_positions)
    add(labels_as_image(pair, position));
  if (options.needs_same_contrast && !has_error(result))
    add(unfit_contrast(pair));
  return result;
}

} // namespace prosup::registration
