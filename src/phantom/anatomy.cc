#include "prosup/phantom/anatomy.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace prosup::phantom {

namespace {

constexpr double lobe_size = 7., branch_size = 3.; // mm, lattice spacings
// mm, thickness of the fat under the skin and on the chest
constexpr double fat_cover = 5., cover_softness = 2.;
constexpr double sample_spacing = 2.5; // mm, for the threshold

} // namespace

Anatomy::Anatomy(const Geometry& geometry, double gland_fraction, std::uint64_t seed)
    : geometry_(geometry), shape_(lobe_size, seed, Stream::gland_shape),
      detail_(branch_size, seed, Stream::gland_detail) {
  if (gland_fraction <= 0.) {
    threshold_ = std::numeric_limits<double>::max();
    return;
  }
  std::vector<double> scores;
  const double front = geometry.skin_y(0., 0.), back = geometry.chest_y(0.5 * geometry.width);
  const double half = 0.5 * sample_spacing;
  for (double z = half - 0.5 * geometry.length; z < 0.5 * geometry.length; z += sample_spacing)
    for (double y = front + half; y < back; y += sample_spacing)
      for (double x = half - 0.5 * geometry.width; x < 0.5 * geometry.width; x += sample_spacing)
        if (geometry.in_tissue({x, y, z}))
          scores.push_back(gland_score({x, y, z}));
  const auto rank = static_cast<std::ptrdiff_t>((1. - gland_fraction) * double(scores.size() - 1));
  std::nth_element(scores.begin(), scores.begin() + rank, scores.end());
  threshold_ = scores[rank];
}

double Anatomy::gland_score(const Point<3>& X) const {
  const double above_chest = geometry_.chest_y(X[0]) - X[1];
  // Distance from the axis of the breast and height above the chest, scaled.
  const double radial = std::hypot(X[0], X[2]) / (1.1 * geometry_.sigma);
  const double height = above_chest / (geometry_.layer + geometry_.height) - 0.5;
  const double middle = -1.8 * radial * radial - 2.5 * height * height;
  const double cover = std::exp((fat_cover - geometry_.depth(X)) / cover_softness) +
                       std::exp((fat_cover - above_chest) / cover_softness);
  return middle - cover + 1.1 * shape_(X) + 0.6 * detail_(X);
}

Label Anatomy::label(const Point<3>& X) const {
  if (!geometry_.in_tissue(X))
    return geometry_.distance_to_chest(X) < 0. ? chest : air;
  return gland_level(X) > 0. ? gland : fat;
}

} // namespace prosup::phantom
