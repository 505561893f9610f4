#include "prosup/prepare/implant.h"

#include <algorithm>
#include <cmath>

#include "prosup/core/error.h"
#include "prosup/core/log.h"
#include "prosup/image/filters.h"
#include "prosup/image/sampling.h"

namespace prosup::prepare {

namespace {

using image::LabelImage;
using image::ScalarImage;

constexpr double edge = 2.;            // mm
constexpr double thin = 10.;           // mm, half of the thickness of what does not count
constexpr float least_fraction = 0.5f; // of gland, or below 0 by as much

/// The fraction of gland on coarse voxels, unlike that of Tissues not limited; 0 outside.
ScalarImage coarse_fraction(const TissueImage& image, const Tissues& tissues) {
  ScalarImage fraction = image::resample_isotropic(image.image, edge);
  const auto& size = fraction.grid.size;
  std::size_t v = 0;
  for (std::size_t k = 0; k < size[2]; ++k)
    for (std::size_t j = 0; j < size[1]; ++j)
      for (std::size_t i = 0; i < size[0]; ++i, ++v) {
        const image::Point<3> p = fraction.grid.physical(double(i), double(j), double(k));
        fraction.values[v] = image::nearest_label(image.inner, p) == 0
                                 ? 0.f
                                 : float((double(fraction.values[v]) - tissues.fat) /
                                         (tissues.gland_intensity - tissues.fat));
      }
  return fraction;
}

bool has_both(const LabelImage& mask) {
  const auto n = std::count(mask.values.begin(), mask.values.end(), 0);
  return n > 0 && std::size_t(n) < mask.values.size();
}

SolidPart measured(const ScalarImage& fraction, const LabelImage& mask) {
  SolidPart part;
  if (!has_both(mask))
    return part;
  const ScalarImage distance = image::signed_distance(mask);
  LabelImage core(mask.grid);
  for (std::size_t v = 0; v < core.values.size(); ++v)
    core.values[v] = double(distance.values[v]) <= -thin;
  core = image::largest_component(core);
  if (!has_both(core))
    return part;
  const ScalarImage to_core = image::signed_distance(core);
  double n = 0., sum = 0., squares = 0.;
  std::size_t deepest = 0;
  for (std::size_t v = 0; v < core.values.size(); ++v) {
    part.volume += double(to_core.values[v]) <= thin ? mask.grid.voxel_volume() / 1000. : 0.;
    if (core.values[v] == 0)
      continue;
    const double value = double(fraction.values[v]);
    n += 1.;
    sum += value;
    squares += value * value;
    if (-double(distance.values[v]) > part.radius) {
      part.radius = -double(distance.values[v]);
      deepest = v;
    }
  }
  part.deviation = std::sqrt(std::max(0., squares / n - (sum / n) * (sum / n)));
  const std::size_t row = mask.grid.size[0], slice = row * mask.grid.size[1];
  const std::size_t i = deepest % row, j = deepest % slice / row, k = deepest / slice;
  part.centre = mask.grid.physical(double(i), double(j), double(k));
  return part;
}

} // namespace

SolidPart largest_solid_part(const TissueImage& image, const Tissues& tissues) {
  const ScalarImage fraction = coarse_fraction(image, tissues);
  LabelImage above(fraction.grid), below(fraction.grid);
  for (std::size_t v = 0; v < fraction.values.size(); ++v) {
    above.values[v] = fraction.values[v] > least_fraction;
    below.values[v] = fraction.values[v] < -least_fraction;
  }
  const SolidPart first = measured(fraction, above), second = measured(fraction, below);
  return first.radius >= second.radius ? first : second;
}

void require_no_implant(const SolidPart& part) {
  if (!part.is_implant())
    return;
  throw Error(format("The breast seems to have an implant: %.0f ml around x = %.0f, y = %.0f, z = "
                     "%.0f mm (LPS) are uniform, no fat, and %.0f mm thick; a breast with an "
                     "implant cannot be registered, so choose the other side or another patient.",
                     part.volume, part.centre[0], part.centre[1], part.centre[2],
                     2. * part.radius));
}

} // namespace prosup::prepare
