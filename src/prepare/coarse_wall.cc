#include "coarse_wall.h"

#include <algorithm>
#include <cmath>

#include "chest_shape.h"
#include "prosup/core/error.h"

namespace prosup::prepare {

namespace {

constexpr double degree = 3.14159265358979323846 / 180.;
constexpr double innermost = 10.; // mm
constexpr double step = 1., slope = 0.06, largest_jump = 3.;
constexpr float untold = 0.5f;        // cost of a wall that nothing speaks for
constexpr double slope_of_pit = 0.05; // cost per mm
constexpr double front_of_pits = 45. * degree;
constexpr unsigned n_rounds_of_pits = 2;
constexpr double foot_of_hill = 3.; // mm
constexpr double least_hill = 11.;  // mm; chests outlined by hand have hills of up to 8 mm
// Chests outlined by hand depart from smooth ones by more than this on 3 cm^2 at most.
constexpr double odd_departure = 16.;        // mm
constexpr double front_angle = 50. * degree; // the sides are no smooth surface
constexpr double least_fat = 3.;             // mm, between skin and chest
constexpr double end_of_scan = 8.;           // mm

} // namespace

ColumnMap radii(const Profiles& profiles, const std::vector<std::size_t>& levels) {
  ColumnMap map(profiles.grid.n_rows, profiles.grid.n_columns);
  for (std::size_t r = 0; r < map.n_rows; ++r)
    for (std::size_t c = 0; c < map.n_columns; ++c)
      map(r, c) = profiles.radius(r, c, double(levels[r * map.n_columns + c]) - 0.5);
  return map;
}

CoarseWall::CoarseWall(const ProfileSource& source, const TrunkAxis& axis, bool fat_is_bright)
    : fat_is_bright_(fat_is_bright) {
  const TrunkGrid grid = trunk_grid(axis, source.image.grid, 1.5 * degree, 3.);
  const auto n_samples =
      static_cast<std::size_t>(std::max(20., largest_radius(source.body, axis) - innermost)) + 4;
  const ColumnMap start(grid.n_rows, grid.n_columns, innermost);
  profiles_ = sample_profiles(source, grid, start, step, n_samples);
  tissue_ = find_front_tissue(profiles_, fat_is_bright);
  if (std::all_of(tissue_.skin.values.begin(), tissue_.skin.values.end(),
                  [](double skin) { return std::isnan(skin); }))
    throw Error("No chest is found behind the breasts; give a scan that shows the chest wall.");
  costs_ = wall_costs(profiles_, tissue_, fat_is_bright, {});
  find_surface(costs_);
}

void CoarseWall::find_surface(const SurfaceCosts& costs) {
  levels_ = minimal_surface(costs, float(slope * step), float(largest_jump), n_wall_sweeps);
  radius_ = smoothed(median_filtered(radii(profiles_, levels_), 1, 1), 1.);
}

double CoarseWall::mean_cost() const {
  double sum = 0.;
  std::size_t n = 0;
  for (std::size_t column = 0; column < levels_.size(); ++column)
    if (!std::isnan(tissue_.skin.values[column])) {
      sum += double(cost(column));
      ++n;
    }
  return n == 0 ? 0. : sum / double(n);
}

ColumnMap CoarseWall::above(const ColumnMap& smooth) const {
  ColumnMap difference = radius_;
  for (std::size_t column = 0; column < difference.values.size(); ++column)
    difference.values[column] -= smooth.values[column];
  return difference;
}

Departure CoarseWall::departure_of(const std::vector<char>& columns,
                                   const ColumnMap& departure) const {
  Departure result;
  for (std::size_t column = 0; column < columns.size(); ++column) {
    if (columns[column] == 0)
      continue;
    const double radius = radius_.values[column];
    result.area += radius * grid().angle_step * grid().z_step / 100.;
    if (std::abs(departure.values[column]) < std::abs(result.largest))
      continue;
    result.largest = departure.values[column];
    result.position =
        grid().axis.position(radius, angle(column), grid().z(column / grid().n_columns));
  }
  return result;
}

std::vector<char> CoarseWall::told_columns(const std::vector<char>& in_front) const {
  std::vector<char> told(in_front.size());
  for (std::size_t column = 0; column < told.size(); ++column)
    told[column] = in_front[column] != 0 && cost(column) < untold;
  return told;
}

SurfaceCosts CoarseWall::costs_above_pits(const ColumnMap& smooth) const {
  SurfaceCosts costs = costs_;
  for (std::size_t r = 0; r < costs.n_rows; ++r)
    for (std::size_t c = 0; c < costs.n_columns; ++c) {
      if (std::abs(grid().angle(c)) > front_of_pits || std::isnan(tissue_.skin(r, c)))
        continue;
      for (std::size_t l = 0; l < costs.n_levels; ++l) {
        const double depth = smooth(r, c) - profiles_.radius(r, c, double(l) - 0.5);
        costs.at(r, c)[l] += float(slope_of_pit * std::max(0., depth - odd_departure));
      }
    }
  return costs;
}

void CoarseWall::correct_shape() {
  if (exclude_muscle(tissue_, fat_is_bright_)) {
    costs_ = wall_costs(profiles_, tissue_, fat_is_bright_, {});
    find_surface(costs_);
  }
  const std::size_t n = levels_.size();
  std::vector<char> in_front(n), odd(n);
  for (std::size_t column = 0; column < n; ++column)
    in_front[column] =
        std::abs(angle(column)) < widest_breast && !std::isnan(tissue_.skin.values[column]);
  std::vector<char> told = told_columns(in_front);
  ColumnMap smooth = smooth_chest(grid(), radius_, told);
  for (unsigned round = 0; round < n_rounds_of_pits; ++round) {
    find_surface(costs_above_pits(smooth));
    told = told_columns(in_front);
    smooth = smooth_chest(grid(), radius_, told);
  }
  hill_ = ColumnMap(grid().n_rows, grid().n_columns);
  ColumnMap surroundings = above(smooth);
  const ColumnMap height = hill_height(surroundings, in_front);
  const std::vector<char> hill = hills(height, foot_of_hill, least_hill);
  if (std::find(hill.begin(), hill.end(), 1) != hill.end()) {
    bridge(surroundings, hill);
    bridged_ = departure_of(hill, height);
    hill_.values.assign(hill.begin(), hill.end());
    for (std::size_t column = 0; column < n; ++column)
      if (hill[column] != 0)
        radius_.values[column] = smooth.values[column] + surroundings.values[column];
  }
  bare_ = ColumnMap(grid().n_rows, grid().n_columns);
  for (std::size_t column = 0; column < n; ++column)
    bare_.values[column] =
        told[column] == 0 && tissue_.skin.values[column] < smooth.values[column] + least_fat;
  const ColumnMap departure = above(smooth);
  const double length = double(grid().n_rows - 1) * grid().z_step;
  for (std::size_t column = 0; column < n; ++column) {
    const std::size_t row = column / grid().n_columns;
    const double along = double(row) * grid().z_step;
    odd[column] = in_front[column] != 0 && std::abs(angle(column)) < front_angle &&
                  along > end_of_scan && along < length - end_of_scan &&
                  std::abs(departure.values[column]) > odd_departure;
  }
  departure_ = departure_of(odd, departure);
}

} // namespace prosup::prepare
