#include "wall_costs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace prosup::prepare {

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr double thinnest_chest = 15.;        // mm
constexpr double skin_thickness = 2.;         // mm
constexpr double fat_from = 4., fat_to = 14.; // mm below the skin
constexpr double most_below_typical = 0.4;    // of the logarithm of fat
constexpr double least_contrast = -0.3;
constexpr double least_front = 2., least_behind = 2.; // mm

/// Radius of the end of the innermost run of body; no number if the image ends before it does.
double skin_of(const Profiles& profiles, std::size_t row, std::size_t column) {
  const char* body = profiles.is_body.data() + profiles.first_of(row, column);
  const std::size_t n = profiles.n_samples;
  const auto first = std::size_t(std::find(body, body + n, char(1)) - body);
  if (first == n)
    return unknown;
  auto end = std::min(n, first + std::size_t(thinnest_chest / profiles.step));
  while (end < n && body[end] != 0)
    ++end;
  if (end < n && profiles.known[profiles.first_of(row, column) + end] == 0)
    return unknown;
  return profiles.radius(row, column, double(end) - 0.5);
}

double fat_of(const Profiles& profiles, std::size_t row, std::size_t column, double skin,
              double share) {
  std::vector<double> values;
  const std::size_t first = profiles.first_of(row, column);
  for (std::size_t i = 0; i < profiles.n_samples; ++i) {
    const double depth = skin - profiles.radius(row, column, double(i));
    if (depth >= fat_from && depth <= fat_to && profiles.is_body[first + i] != 0)
      values.push_back(double(profiles.u[first + i]));
  }
  return quantile_of(std::move(values), share);
}

/// The sums that the costs of one column are made of.
class ColumnSums {
public:
  ColumnSums(const Profiles& profiles, std::size_t row, std::size_t column, double skin, double fat,
             bool fat_is_bright) {
    const std::size_t first = profiles.first_of(row, column);
    for (std::size_t i = 0; i < profiles.n_samples; ++i) {
      const double depth = skin - profiles.radius(row, column, double(i));
      const bool body = profiles.is_body[first + i] != 0 && depth > 0.;
      const bool below_skin = body && depth >= skin_thickness;
      const double u = double(profiles.u[first + i]);
      const double off = fat_is_bright ? fat - u : std::abs(u - fat);
      n_body.add(body ? 1. : 0.);
      of_body.add(body ? u : 0.);
      n_inner.add(below_skin ? 1. : 0.);
      of_inner.add(below_skin ? u : 0.);
      of_deviation.add(below_skin ? std::clamp(off, 0., 1.) : 0.);
    }
  }

  RunningSum n_body, of_body, n_inner, of_inner, of_deviation;
};

float cost(const ColumnSums& sums, long level, double step, bool fat_is_bright,
           const WallWindows& windows) {
  const long front = std::lround(windows.front / step), behind = std::lround(windows.behind / step);
  const long far = std::lround(windows.far_front / step);
  const double n_front = sums.n_inner(level, level + front);
  const double n_behind = sums.n_body(level - behind, level);
  if (n_front * step < least_front || n_behind * step < least_behind)
    return no_wall;
  const double difference = sums.of_inner(level, level + front) / n_front -
                            sums.of_body(level - behind, level) / n_behind;
  const double contrast = std::clamp(fat_is_bright ? difference : -difference, least_contrast,
                                     windows.largest_contrast);
  const double near_fat = sums.of_deviation(level, level + front) / n_front;
  const double far_fat =
      far == 0 ? 0. : sums.of_deviation(level + front, level + front + far) / double(far);
  return float(-contrast + windows.fat_weight * near_fat + windows.far_weight * far_fat);
}

} // namespace

FrontTissue find_front_tissue(const Profiles& profiles, bool fat_is_bright) {
  const std::size_t n_rows = profiles.grid.n_rows, n_columns = profiles.grid.n_columns;
  FrontTissue tissue{ColumnMap(n_rows, n_columns, unknown), ColumnMap(n_rows, n_columns, unknown)};
  for (std::size_t r = 0; r < n_rows; ++r)
    for (std::size_t c = 0; c < n_columns; ++c) {
      tissue.skin(r, c) = skin_of(profiles, r, c);
      // Gland, vessels and skin are brighter than suppressed fat.
      tissue.fat(r, c) = fat_of(profiles, r, c, tissue.skin(r, c), fat_is_bright ? 0.5 : 0.35);
    }
  const double typical = quantile_of(tissue.fat.values, 0.5);
  tissue.fat = smoothed(median_filtered(tissue.fat, 4, 6), 3.);
  for (double& fat : tissue.fat.values)
    if (std::isnan(fat))
      fat = typical;
  return tissue;
}

bool exclude_muscle(FrontTissue& tissue, bool fat_is_bright) {
  if (!fat_is_bright)
    return false; // suppressed fat may be uneven
  const double least = quantile_of(tissue.fat.values, 0.5) - most_below_typical;
  bool is_changed = false;
  for (double& fat : tissue.fat.values)
    if (fat < least) {
      fat = least;
      is_changed = true;
    }
  return is_changed;
}

SurfaceCosts wall_costs(const Profiles& profiles, const FrontTissue& tissue, bool fat_is_bright,
                        const WallWindows& windows) {
  const std::size_t n_rows = profiles.grid.n_rows, n_columns = profiles.grid.n_columns;
  SurfaceCosts costs(n_rows, n_columns, profiles.n_samples);
  for (std::size_t r = 0; r < n_rows; ++r)
    for (std::size_t c = 0; c < n_columns; ++c) {
      const double skin = tissue.skin(r, c);
      if (std::isnan(skin))
        continue; // its neighbours decide
      const ColumnSums sums(profiles, r, c, skin, tissue.fat(r, c), fat_is_bright);
      for (std::size_t l = 0; l < profiles.n_samples; ++l)
        costs.at(r, c)[l] = profiles.known[profiles.first_of(r, c) + l] != 0
                                ? cost(sums, long(l), profiles.step, fat_is_bright, windows)
                                : no_wall;
    }
  return costs;
}

} // namespace prosup::prepare
