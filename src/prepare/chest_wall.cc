#include "prosup/prepare/chest_wall.h"

#include <algorithm>
#include <cmath>

#include "coarse_wall.h"
#include "fat_sign.h"
#include "prosup/image/filters.h"

namespace prosup::prepare {

namespace {

constexpr double degree = 3.14159265358979323846 / 180.;
constexpr double working_edge = 1.5; // mm
constexpr double fine_step = 0.5, fine_slope = 0.02, fine_largest = 3.;
constexpr double band = 8.; // mm on both sides of the coarse surface
constexpr double narrow_band =
    3.;                        // in front, where gland hides it, whose front must not be reached
constexpr double beyond = 4.;  // mm of samples beyond the band
constexpr float pull = 0.002f; // to the coarse surface, per mm^2
constexpr double skin_and_a_voxel = 3.; // mm
constexpr WallWindows fine_windows{3., 3., 0., 0., 0., 0.7};

/// A map of the columns of one grid at those of another.
ColumnMap resampled(const ColumnMap& map, const TrunkGrid& from, const TrunkGrid& to) {
  const TrunkSurface surface{from, map.values};
  ColumnMap result(to.n_rows, to.n_columns);
  for (std::size_t r = 0; r < to.n_rows; ++r)
    for (std::size_t c = 0; c < to.n_columns; ++c)
      result(r, c) = surface(to.angle(c), to.z(r));
  return result;
}

/// Keeps the surface near to the coarse one.
void confine(SurfaceCosts& costs, const ColumnMap& hill) {
  const double middle = (band + beyond) / fine_step;
  for (std::size_t r = 0; r < costs.n_rows; ++r)
    for (std::size_t c = 0; c < costs.n_columns; ++c)
      for (std::size_t l = 0; l < costs.n_levels; ++l) {
        const double distance = (double(l) - 0.5 - middle) * fine_step;
        costs.at(r, c)[l] = distance < -band || distance > (hill(r, c) > 0. ? narrow_band : band)
                                ? 2.f * no_wall
                                : costs.at(r, c)[l] + pull * float(distance * distance);
      }
}

ChestWall refined(const ProfileSource& source, const CoarseWall& coarse, bool fat_is_bright) {
  const TrunkGrid grid = trunk_grid(coarse.grid().axis, source.image.grid, degree, 2.);
  ColumnMap start = resampled(coarse.radius(), coarse.grid(), grid);
  for (double& radius : start.values)
    radius -= band + beyond;
  const auto n_samples = static_cast<std::size_t>(2. * (band + beyond) / fine_step) + 1;
  const Profiles profiles = sample_profiles(source, grid, start, fine_step, n_samples);
  const FrontTissue tissue{resampled(coarse.tissue().skin, coarse.grid(), grid),
                           resampled(coarse.tissue().fat, coarse.grid(), grid)};
  SurfaceCosts costs = wall_costs(profiles, tissue, fat_is_bright, fine_windows);
  const SurfaceCosts contrast = costs;
  confine(costs, resampled(coarse.hill(), coarse.grid(), grid));
  const auto levels = minimal_surface(costs, float(fine_slope), float(fine_largest), n_wall_sweeps);
  ChestWall wall;
  wall.surface.grid = grid;
  wall.surface.radius = smoothed(median_filtered(radii(profiles, levels), 1, 1), 0.8).values;
  const ColumnMap bare = resampled(coarse.bare(), coarse.grid(), grid);
  for (std::size_t column = 0; column < levels.size(); ++column)
    if (bare.values[column] > 0.5)
      wall.surface.radius[column] = tissue.skin.values[column] + skin_and_a_voxel;
  for (std::size_t column = 0; column < levels.size(); ++column)
    wall.edge.push_back(
        std::isnan(tissue.skin.values[column])
            ? ChestWall::no_edge
            : -double(contrast.values[column * contrast.n_levels + levels[column]]));
  wall.bridged = coarse.bridged();
  wall.departure = coarse.departure();
  wall.fat.is_bright = fat_is_bright;
  return wall;
}

} // namespace

ChestWall find_chest_wall(const ChestImage& image, const TrunkAxis& axis,
                          std::optional<bool> fat_is_bright) {
  const image::ScalarImage working = image::resample_isotropic(image.image, working_edge);
  const ProfileSource source{working, image.body, image.air, image.is_ct};
  if (fat_is_bright) {
    CoarseWall coarse(source, axis, *fat_is_bright);
    coarse.correct_shape();
    return refined(source, coarse, *fat_is_bright);
  }
  CoarseWall dark(source, axis, false), bright(source, axis, true);
  const double sign = dark.mean_cost() - bright.mean_cost() +
                      FatSign::weight_of_darker * darker_than_fat(source, axis);
  const bool is_bright = sign > FatSign::middle;
  CoarseWall& coarse = is_bright ? bright : dark;
  coarse.correct_shape();
  ChestWall wall = refined(source, coarse, is_bright);
  wall.fat = {is_bright, std::abs(sign - FatSign::middle) < FatSign::doubtful};
  return wall;
}

} // namespace prosup::prepare
