#include "prosup/prepare/chest_wall.h"

#include <algorithm>
#include <cmath>

#include "prosup/core/error.h"
#include "prosup/image/filters.h"
#include "wall_costs.h"

namespace prosup::prepare {

namespace {

constexpr double degree = 3.14159265358979323846 / 180.;
constexpr double working_edge = 1.5; // mm
constexpr double innermost = 10.;    // mm
constexpr unsigned n_sweeps = 4;

constexpr double coarse_step = 1., coarse_slope = 0.06, coarse_largest = 3.;
constexpr double fine_step = 0.5, fine_slope = 0.02, fine_largest = 3.;
constexpr double band = 8.;    // mm on both sides of the coarse surface
constexpr double beyond = 4.;  // mm of samples beyond the band
constexpr float pull = 0.002f; // to the coarse surface, per mm^2
constexpr WallWindows fine_windows{3., 3., 0., 0., 0., 0.7};

/// Largest radius of a body, mm.
double largest_radius(const image::LabelImage& body, const TrunkAxis& axis) {
  double largest = 0.;
  const auto& size = body.grid.size;
  for (std::size_t k = 0; k < size[2]; k += 2)
    for (std::size_t j = 0; j < size[1]; j += 2)
      for (std::size_t i = 0; i < size[0]; i += 2)
        if (body(i, j, k) != 0)
          largest =
              std::max(largest, axis.radius(body.grid.physical(double(i), double(j), double(k))));
  return largest;
}

ColumnMap radii(const Profiles& profiles, const std::vector<std::size_t>& levels) {
  ColumnMap map(profiles.grid.n_rows, profiles.grid.n_columns);
  for (std::size_t r = 0; r < map.n_rows; ++r)
    for (std::size_t c = 0; c < map.n_columns; ++c)
      map(r, c) = profiles.radius(r, c, double(levels[r * map.n_columns + c]) - 0.5);
  return map;
}

/// A map of the columns of one grid at those of another.
ColumnMap resampled(const ColumnMap& map, const TrunkGrid& from, const TrunkGrid& to) {
  const TrunkSurface surface{from, map.values};
  ColumnMap result(to.n_rows, to.n_columns);
  for (std::size_t r = 0; r < to.n_rows; ++r)
    for (std::size_t c = 0; c < to.n_columns; ++c)
      result(r, c) = surface(to.angle(c), to.z(r));
  return result;
}

double mean_cost(const SurfaceCosts& costs, const FrontTissue& tissue,
                 const std::vector<std::size_t>& levels) {
  double sum = 0.;
  std::size_t n = 0;
  for (std::size_t column = 0; column < levels.size(); ++column)
    if (!std::isnan(tissue.skin.values[column])) {
      sum += double(costs.values[column * costs.n_levels + levels[column]]);
      ++n;
    }
  return n == 0 ? 0. : sum / double(n);
}

/// The coarse surface, and what was found with it.
struct CoarseWall {
  TrunkGrid grid;
  FrontTissue tissue;
  ColumnMap radius;
  double cost = 0.;
};

CoarseWall find_coarse(const ProfileSource& source, const TrunkAxis& axis, bool fat_is_bright) {
  CoarseWall wall;
  wall.grid = trunk_grid(axis, source.image.grid, 1.5 * degree, 3.);
  const auto n_samples =
      static_cast<std::size_t>(std::max(20., largest_radius(source.body, axis) - innermost)) + 4;
  const ColumnMap start(wall.grid.n_rows, wall.grid.n_columns, innermost);
  const Profiles profiles = sample_profiles(source, wall.grid, start, coarse_step, n_samples);
  wall.tissue = find_front_tissue(profiles, fat_is_bright);
  if (std::all_of(wall.tissue.skin.values.begin(), wall.tissue.skin.values.end(),
                  [](double skin) { return std::isnan(skin); }))
    throw Error("No chest is found behind the breasts; give a scan that shows the chest wall.");
  const SurfaceCosts costs = wall_costs(profiles, wall.tissue, fat_is_bright, {});
  const auto levels =
      minimal_surface(costs, float(coarse_slope * coarse_step), float(coarse_largest), n_sweeps);
  wall.cost = mean_cost(costs, wall.tissue, levels);
  wall.radius = smoothed(median_filtered(radii(profiles, levels), 1, 1), 1.);
  return wall;
}

void confine(SurfaceCosts& costs) {
  const double middle = (band + beyond) / fine_step;
  for (std::size_t r = 0; r < costs.n_rows; ++r)
    for (std::size_t c = 0; c < costs.n_columns; ++c)
      for (std::size_t l = 0; l < costs.n_levels; ++l) {
        const double distance = (double(l) - 0.5 - middle) * fine_step;
        costs.at(r, c)[l] = std::abs(distance) > band
                                ? 2.f * no_wall
                                : costs.at(r, c)[l] + pull * float(distance * distance);
      }
}

ChestWall refined(const ProfileSource& source, const CoarseWall& coarse, bool fat_is_bright) {
  const TrunkGrid grid = trunk_grid(coarse.grid.axis, source.image.grid, degree, 2.);
  ColumnMap start = resampled(coarse.radius, coarse.grid, grid);
  for (double& radius : start.values)
    radius -= band + beyond;
  const auto n_samples = static_cast<std::size_t>(2. * (band + beyond) / fine_step) + 1;
  const Profiles profiles = sample_profiles(source, grid, start, fine_step, n_samples);
  const FrontTissue tissue{resampled(coarse.tissue.skin, coarse.grid, grid),
                           resampled(coarse.tissue.fat, coarse.grid, grid)};
  SurfaceCosts costs = wall_costs(profiles, tissue, fat_is_bright, fine_windows);
  const SurfaceCosts contrast = costs;
  confine(costs);
  const auto levels = minimal_surface(costs, float(fine_slope), float(fine_largest), n_sweeps);
  ChestWall wall;
  wall.surface.grid = grid;
  wall.surface.radius = smoothed(median_filtered(radii(profiles, levels), 1, 1), 0.8).values;
  for (std::size_t column = 0; column < levels.size(); ++column)
    wall.edge.push_back(
        std::isnan(tissue.skin.values[column])
            ? ChestWall::no_edge
            : -double(contrast.values[column * contrast.n_levels + levels[column]]));
  wall.fat.is_bright = fat_is_bright;
  return wall;
}

} // namespace

ChestWall find_chest_wall(const ChestImage& image, const TrunkAxis& axis,
                          std::optional<bool> fat_is_bright) {
  const image::ScalarImage working = image::resample_isotropic(image.image, working_edge);
  const ProfileSource source{working, image.body, image.air, image.is_ct};
  if (fat_is_bright)
    return refined(source, find_coarse(source, axis, *fat_is_bright), *fat_is_bright);
  const CoarseWall dark = find_coarse(source, axis, false),
                   bright = find_coarse(source, axis, true);
  const double difference = dark.cost - bright.cost;
  const bool is_bright = difference > FatSign::middle;
  ChestWall wall = refined(source, is_bright ? bright : dark, is_bright);
  wall.fat = {is_bright, std::abs(difference - FatSign::middle) < FatSign::doubtful};
  return wall;
}

} // namespace prosup::prepare
