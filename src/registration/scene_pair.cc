#include "scene_pair.h"

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "outlines.h"
#include "prosup/core/quantile.h"
#include "prosup/image/filters.h"
#include "prosup/image/sampling.h"

namespace prosup::registration {

using dealii::Point;
using dealii::Tensor;
using image::ScalarImage;

namespace {

constexpr double pixel = 6.; // mm, of the views
constexpr std::size_t n_values_counted = 16;

/// Distances of the points of one breast's base from the chest of another one, in its image.
std::vector<double> distances(const BreastMeasures& points, const BreastMeasures& chest) {
  std::vector<double> found;
  if (chest.chest_distance.values.empty())
    return found;
  const image::VoxelGrid& grid = chest.chest_distance.grid;
  const image::BasicSampler<double> distance(chest.chest_distance);
  for (const Point<3>& x : points.base) {
    if (lies_within(grid, x))
      found.push_back(std::abs(distance.value(x)));
  }
  return found;
}

double share(std::size_t part, std::size_t all) {
  return all > 0 ? double(part) / double(all) : 0.;
}

void compare_chests(const PerPosition<BreastMeasures>& breasts, PairMeasures& result) {
  std::vector<double> all;
  for (const Position position : both_positions) {
    const std::vector<double> found = distances(breasts[position], breasts[other(position)]);
    result.in_view[position] = share(found.size(), breasts[position].base.size());
    all.insert(all.end(), found.begin(), found.end());
  }
  if (all.empty())
    return;
  result.chest_median = quantile(all, 0.5);
  result.chest_p90 = quantile(std::move(all), 0.9);
}

std::optional<TissueContrast> contrast_of(const ScalarImage& image, const image::LabelImage& labels,
                                          const Labels& meaning) {
  if (meaning.gland == 0)
    return {};
  std::vector<double> fat, gland;
  const std::array<bool, 256> is_tissue = tissue_table(meaning);
  for (std::size_t v = 0; v < labels.values.size(); ++v)
    if (labels.values[v] == meaning.gland)
      gland.push_back(image.values[v]);
    else if (is_tissue[labels.values[v]])
      fat.push_back(image.values[v]);
  if (fat.empty() || gland.empty())
    return {};
  return TissueContrast{quantile(std::move(fat), 0.5), quantile(std::move(gland), 0.5)};
}

/// Intensities of the tissue without its outer 2 mm, which are partly air or chest where slices are
/// thick or a mask is off; of all tissue if it is thin everywhere.
std::vector<double> inner_intensities(const ScalarImage& image, const image::LabelImage& labels,
                                      const Labels& meaning) {
  constexpr double outline = 2.; // mm
  constexpr double least_part = 0.3;
  const auto in_mask = [&](const image::LabelImage& mask) {
    std::vector<double> values;
    for (std::size_t v = 0; v < mask.values.size(); ++v)
      if (mask.values[v] != 0)
        values.push_back(image.values[v]);
    return values;
  };
  const image::LabelImage tissue = image::select_labels(labels, meaning.tissues);
  std::vector<double> all = in_mask(tissue), inner = in_mask(image::inner_part(tissue, outline));
  return double(inner.size()) < least_part * double(all.size()) ? all : inner;
}

/// Parts of these values in bins between their percentiles 1 and 99.
std::vector<double> histogram(const std::vector<double>& values) {
  constexpr std::size_t n_bins = 24;
  std::vector<double> bins(n_bins, 0.);
  if (values.empty())
    return bins;
  const double low = quantile(values, 0.01), high = quantile(values, 0.99);
  for (const double value : values) {
    // Shared by the two nearest bins, so that a narrow peak may lie anywhere.
    const double part = (value - low) / std::max(high - low, 1e-6);
    const double bin = std::clamp((part + 0.1) / 1.2, 0., 0.9999) * double(n_bins - 1);
    const auto below = std::size_t(bin);
    bins[below] += (1. - (bin - double(below))) / double(values.size());
    bins[below + 1] += (bin - double(below)) / double(values.size());
  }
  return bins;
}

void compare_intensities(const PerPosition<BreastMeasures>& breasts, const Inputs& inputs,
                         const Labels& meaning, double edge, PairMeasures& result) {
  PerPosition<std::vector<double>> bins;
  PerPosition<ScalarImage> images;
  for (const Position position : both_positions) {
    const image::LabelImage& labels = breasts[position].labels;
    const ScalarImage& image = images[position] = thinned(inputs.images[position], edge);
    result.contrast[position] = contrast_of(image, labels, meaning);
    bins[position] = histogram(inner_intensities(image, labels, meaning));
    const OriginalImage& original = inputs.originals[position];
    std::set<float> values;
    for (std::size_t v = 0; v < original.breast.values.size() && values.size() < n_values_counted;
         ++v)
      if (original.breast.values[v] != 0)
        values.insert(original.image.values[v]);
    result.n_values[position] = values.size();
  }
  result.information = chest_information(breasts, images);
  result.common_histogram = 0.;
  for (std::size_t b = 0; b < bins.prone.size(); ++b)
    result.common_histogram += std::min(bins.prone[b], bins.supine[b]);
}

/// Extent of the tissue along the patient's left, mm, and its centre.
double width(const BreastMeasures& breast, const Labels& meaning) {
  const std::array<bool, 256> is_tissue = tissue_table(meaning);
  const auto& size = breast.labels.grid.size;
  double low = 1e300, high = -1e300;
  for (std::size_t v = 0; v < breast.labels.values.size(); ++v)
    if (is_tissue[breast.labels.values[v]]) {
      const double x = breast.labels.grid.physical(
          double(v % size[0]), double(v / size[0] % size[1]), double(v / size[0] / size[1]))[0];
      low = std::min(low, x);
      high = std::max(high, x);
    }
  return std::max(high - low, 1e-9);
}

} // namespace

bool lies_within(const image::VoxelGrid& grid, const Point<3>& x) {
  const Point<3> index = grid.continuous_index(x);
  for (unsigned d = 0; d < 3; ++d)
    if (!(index[d] >= 0. && index[d] <= double(grid.size[d]) - 1.))
      return false;
  return true;
}

PairMeasures compare(const PerPosition<BreastMeasures>& breasts, const Inputs& inputs,
                     const PerPosition<Tensor<1, 3>>& gravity, const Labels& meaning, double edge) {
  PairMeasures result;
  const auto& [prone, supine] = breasts;
  result.facing = prone.front * supine.front;
  const double cosine =
      gravity.prone * gravity.supine / (gravity.prone.norm() * gravity.supine.norm());
  result.gravity_angle = 180. / dealii::numbers::PI * std::acos(std::clamp(cosine, -1., 1.));
  compare_chests(breasts, result);
  const auto ratio = [](double a, double b) { return b > 0. ? a / b : 0.; };
  result.volume_ratio = ratio(prone.tissue_ml, supine.tissue_ml);
  result.gland_ratio = ratio(prone.gland_ml, supine.gland_ml);
  result.width_ratio = ratio(width(prone, meaning), width(supine, meaning));
  if (prone.reach && supine.reach)
    result.reach_ratio = ratio(*prone.reach, *supine.reach);
  if (prone.front.norm() > 0. && supine.front.norm() > 0.)
    result.fit = fit_of(front_view(prone, meaning, prone.front, pixel),
                        front_view(supine, meaning, supine.front, pixel));
  compare_intensities(breasts, inputs, meaning, edge, result);
  result.same_image = inputs.originals.prone.image.values == inputs.originals.supine.image.values;
  result.same_labels = inputs.scene.labels.prone.values == inputs.scene.labels.supine.values;
  return result;
}

} // namespace prosup::registration
