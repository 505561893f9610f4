#include "prosup/image/contrast.h"

#include <algorithm>
#include <utility>

#include "prosup/core/error.h"
#include "prosup/core/log.h"
#include "prosup/core/quantile.h"
#include "prosup/image/filters.h"

namespace prosup::image {

namespace {

/// The line that takes two intensities to two others.
struct Line {
  double start, slope, end;
  Line(double from, double from_other, double to, double to_other)
      : start(from), slope((to_other - to) / (from_other - from)), end(to) {}
  double at(double intensity) const { return end + slope * (intensity - start); }
};

/// How deep voxels lie under air, in voxels, from 0 to 1.
ScalarImage depth_below_air(const LabelImage& labels) {
  LabelImage body(labels.grid);
  std::transform(labels.values.begin(), labels.values.end(), body.values.begin(),
                 [](std::uint8_t label) { return std::uint8_t(label != 0); });
  if (std::find(body.values.begin(), body.values.end(), 0) == body.values.end())
    return ScalarImage(labels.grid, 1.f);
  ScalarImage depth = signed_distance(body);
  const auto& spacing = labels.grid.spacing;
  const double edge = std::min({spacing[0], spacing[1], spacing[2]});
  for (float& value : depth.values)
    value = static_cast<float>(std::clamp(-value / edge, 0., 1.));
  return depth;
}

} // namespace

float median_intensity(const ScalarImage& image, const LabelImage& labels, unsigned label) {
  if (labels.grid.size != image.grid.size)
    throw Error("A median intensity needs labels of the size of the image; resample the labels.");
  std::vector<float> values;
  for (std::size_t v = 0; v < labels.values.size(); ++v)
    if (labels.values[v] == label)
      values.push_back(image.values[v]);
  if (values.empty())
    throw Error(
        format("The median intensity of label %u is needed, but the label image has no voxel "
               "of it; label this tissue, or give the right label.",
               label));
  return quantile(std::move(values), 0.5);
}

ScalarImage convert_contrast(const ScalarImage& image, const LabelImage& labels,
                             const TissueIntensities& from, const TissueIntensities& to) {
  if (from.fat == from.gland || from.fat == from.air)
    throw Error(format("The contrast cannot be converted, since air, fat and gland have the "
                       "intensities %g, %g and %g and fat must differ from both; check the "
                       "labels, or leave the contrast as given.",
                       from.air, from.fat, from.gland));
  const Line outline(from.air, from.fat, to.air, to.fat);
  const Line tissue(from.fat, from.gland, to.fat, to.gland);
  const ScalarImage depth = depth_below_air(labels);
  ScalarImage result(image.grid);
  for (std::size_t v = 0; v < image.values.size(); ++v) {
    const double intensity = image.values[v];
    const double converted =
        (1. - depth.values[v]) * outline.at(intensity) + depth.values[v] * tissue.at(intensity);
    result.values[v] =
        static_cast<float>(std::clamp(converted, rescaled_range.low, rescaled_range.high));
  }
  return result;
}

} // namespace prosup::image
