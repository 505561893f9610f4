#include <algorithm>
#include <cmath>

#include "prosup/core/error.h"
#include "prosup/core/log.h"
#include "prosup/image/filters.h"

namespace prosup::image {

namespace {

/// Value at a percentile, interpolated between ranks; reorders `values`.
double percentile(std::vector<float>& values, double percent) {
  const double rank = percent / 100. * double(values.size() - 1);
  const auto below = values.begin() + static_cast<std::ptrdiff_t>(rank);
  std::nth_element(values.begin(), below, values.end());
  const double low = *below;
  if (below + 1 == values.end())
    return low;
  const double high = *std::min_element(below + 1, values.end());
  return low + (rank - std::floor(rank)) * (high - low);
}

} // namespace

IntensityRange robust_range(const ScalarImage& image, const LabelImage& mask, double low_percentile,
                            double high_percentile) {
  if (!(0. <= low_percentile && low_percentile < high_percentile && high_percentile <= 100.))
    throw Error(
        format("The percentiles of the intensity range are %g and %g, but must increase and "
               "lie between 0 and 100.",
               low_percentile, high_percentile));
  if (mask.grid.size != image.grid.size)
    throw Error("The intensity range needs a mask of the size of the image; resample the mask.");
  std::vector<float> inside;
  for (std::size_t v = 0; v < mask.values.size(); ++v)
    if (mask.values[v] != 0)
      inside.push_back(image.values[v]);
  if (inside.empty())
    throw Error("The intensity range cannot be found because the mask is empty; correct the mask.");
  const IntensityRange range{percentile(inside, low_percentile),
                             percentile(inside, high_percentile)};
  if (!(range.low < range.high))
    throw Error(format("The image has the same intensity %g at percentiles %g and %g of its mask; "
                       "give an image with contrast, or percentiles further apart.",
                       range.low, low_percentile, high_percentile));
  return range;
}

ScalarImage rescale(const ScalarImage& image, IntensityRange range) {
  if (!(range.low < range.high))
    throw Error(format("The intensity range to rescale from is %g to %g, but must increase.",
                       range.low, range.high));
  ScalarImage result(image.grid);
  std::transform(image.values.begin(), image.values.end(), result.values.begin(), [&](float value) {
    const double scaled = (value - range.low) / (range.high - range.low);
    return static_cast<float>(std::clamp(scaled, rescaled_range.low, rescaled_range.high));
  });
  return result;
}

} // namespace prosup::image
