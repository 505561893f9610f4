#include <algorithm>
#include <cmath>
#include <vector>

#include "prosup/image/filters.h"
#include "prosup/image/sampling.h"
#include "scene_pair.h"

namespace prosup::registration {

using namespace dealii;
using image::ScalarImage;

namespace {

// The layer of the chest with its ribs: not its surface, where voxels are partly tissue, and not
// the organs, which move. mm.
constexpr double cover = 3., depth = 25.;
constexpr double sigma = 2.5; // mm, against noise
constexpr std::size_t n_bins = 16, fewest_points = 500;

/// Ranks of values in n_bins groups of one size.
std::vector<std::size_t> groups(const std::vector<float>& values) {
  std::vector<float> sorted = values;
  std::sort(sorted.begin(), sorted.end());
  std::vector<float> limits;
  for (std::size_t b = 1; b < n_bins; ++b)
    limits.push_back(sorted[b * sorted.size() / n_bins]);
  std::vector<std::size_t> result;
  for (const float value : values)
    result.push_back(
        std::size_t(std::upper_bound(limits.begin(), limits.end(), value) - limits.begin()));
  return result;
}

/// Mutual information of two lists of values, nats.
double information(const std::vector<float>& a, const std::vector<float>& b) {
  const std::vector<std::size_t> ga = groups(a), gb = groups(b);
  std::array<std::array<double, n_bins>, n_bins> joint{};
  std::array<double, n_bins> pa{}, pb{};
  const double one = 1. / double(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    joint[ga[i]][gb[i]] += one;
    pa[ga[i]] += one;
    pb[gb[i]] += one;
  }
  double sum = 0.;
  for (std::size_t i = 0; i < n_bins; ++i)
    for (std::size_t j = 0; j < n_bins; ++j)
      if (joint[i][j] > 0.)
        sum += joint[i][j] * std::log(joint[i][j] / (pa[i] * pb[j]));
  return sum;
}

/// A point of the chest and the intensity there.
struct ChestPoint {
  Point<3> x;
  float value;
};

std::vector<ChestPoint> layer(const BreastMeasures& breast, const ScalarImage& image) {
  std::vector<ChestPoint> points;
  const auto& [grid, distance] = breast.chest_distance;
  std::size_t v = 0;
  for (std::size_t k = 0; k < grid.size[2]; ++k)
    for (std::size_t j = 0; j < grid.size[1]; ++j)
      for (std::size_t i = 0; i < grid.size[0]; ++i, ++v)
        if (distance[v] < -cover && distance[v] > -depth)
          points.push_back({grid.physical(double(i), double(j), double(k)), image.values[v]});
  return points;
}

} // namespace

Turned chest_information(const PerPosition<BreastMeasures>& breasts,
                         const PerPosition<ScalarImage>& images) {
  if (breasts.prone.chest_distance.values.empty() || breasts.supine.chest_distance.values.empty())
    return {};
  const std::vector<ChestPoint> points =
      layer(breasts.prone, image::gaussian_smooth(images.prone, sigma));
  const ScalarImage supine = image::gaussian_smooth(images.supine, sigma);
  const image::BasicSampler<float> intensity(supine), distance(breasts.supine.chest_distance);
  Point<3> centre;
  for (const ChestPoint& point : points)
    centre += (point.x - Point<3>()) / double(points.size());
  const auto found = [&](bool left_right, bool head_foot) {
    std::vector<float> a, b;
    for (const ChestPoint& point : points) {
      Point<3> x = point.x;
      if (left_right)
        x[0] = 2. * centre[0] - x[0];
      if (head_foot)
        x[2] = 2. * centre[2] - x[2];
      if (lies_within(supine.grid, x) && distance.value(x) < -1.f) {
        a.push_back(point.value);
        b.push_back(intensity.value(x));
      }
    }
    return a.size() < fewest_points ? 0. : information(a, b);
  };
  return {found(false, false), found(true, false), found(false, true), found(true, true)};
}

} // namespace prosup::registration
