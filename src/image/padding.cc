#include <algorithm>
#include <cmath>
#include <iterator>

#include "prosup/core/error.h"
#include "prosup/image/filters.h"

namespace prosup::image {

namespace {

constexpr double least_share = 0.01; // of the air, of padding and of what is no padding

/// The value at a fraction of the sorted values; reorders them.
double at_fraction(std::vector<float>& values, double fraction) {
  const auto place =
      values.begin() + static_cast<std::ptrdiff_t>(fraction * double(values.size() - 1));
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

/// Intensities outside and inside of the labelled body.
struct Intensities {
  std::vector<float> air, body;
};

/// Whether `value` is no intensity of the scan: it is much further from the rest of the air than
/// the body is, and that rest is uniform. Returns the intensity of the air then.
std::optional<double> air_beside(float value, const Intensities& all) {
  std::vector<float> rest, body = all.body;
  std::copy_if(all.air.begin(), all.air.end(), std::back_inserter(rest),
               [&](float v) { return v != value; });
  const double n_air = double(all.air.size());
  const double n_padded = n_air - double(rest.size());
  if (n_padded < least_share * n_air || double(rest.size()) < least_share * n_air)
    return {};
  const double air = at_fraction(rest, 0.5);
  const double spread = at_fraction(rest, 0.75) - at_fraction(rest, 0.25);
  const double low = at_fraction(body, 0.01), high = at_fraction(body, 0.99);
  const auto nearest = std::min_element(rest.begin(), rest.end(), [&](float a, float b) {
    return std::abs(a - value) < std::abs(b - value);
  });
  const double gap = std::abs(*nearest - value), contrast = low - air;
  const bool is_far = gap > 0.5 * (high - low) && gap > 0.75 * contrast;
  return contrast > 0. && spread < 0.25 * contrast && is_far ? std::optional<double>(air)
                                                             : std::nullopt;
}

} // namespace

std::optional<Padding> replace_padding(ScalarImage& image, const LabelImage& labels) {
  if (labels.values.size() != image.values.size())
    throw Error("Padding is found with labels of the size of the image; resample the labels.");
  Intensities all;
  for (std::size_t v = 0; v < labels.values.size(); ++v)
    (labels.values[v] == 0 ? all.air : all.body).push_back(image.values[v]);
  if (all.air.empty() || all.body.empty())
    return {};
  const auto [low, high] = std::minmax_element(all.air.begin(), all.air.end());
  for (const float value : {*low, *high})
    if (const auto air = air_beside(value, all)) {
      Padding padding{value, *air, 0.};
      for (std::size_t v = 0; v < labels.values.size(); ++v)
        if (labels.values[v] == 0 && image.values[v] == value) {
          image.values[v] = static_cast<float>(*air);
          padding.share += 1. / double(all.air.size());
        }
      return padding;
    }
  return {};
}

} // namespace prosup::image
