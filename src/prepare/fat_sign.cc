#include "fat_sign.h"

#include <cmath>

#include "wall_costs.h"

namespace prosup::prepare {

namespace {

constexpr double degree = 3.14159265358979323846 / 180.;
constexpr double innermost = 10., step = 2.; // mm
constexpr double shallow = 4., deep = 60.;   // mm below the skin
constexpr double as_fat = 0.3;               // difference of logarithms
constexpr float signal = 4.f;                // times the intensity of air: below is lung

/// Of the samples of one column, those that are brighter and darker than fat.
struct Counts {
  double brighter = 0., darker = 0.;

  void add(const Profiles& profiles, const FrontTissue& tissue, std::size_t row, std::size_t column,
           double darkest) {
    const double skin = tissue.skin(row, column), fat = tissue.fat(row, column);
    const std::size_t first = profiles.first_of(row, column);
    for (std::size_t i = 0; i < profiles.n_samples; ++i) {
      const double depth = skin - profiles.radius(row, column, double(i));
      const auto u = double(profiles.u[first + i]);
      if (profiles.is_body[first + i] == 0 || depth < shallow || depth > deep || u < darkest)
        continue;
      brighter += u > fat + as_fat ? 1. : 0.;
      darker += u < fat - as_fat ? 1. : 0.;
    }
  }
};

} // namespace

double darker_than_fat(const ProfileSource& source, const TrunkAxis& axis) {
  const TrunkGrid grid = trunk_grid(axis, source.image.grid, 3. * degree, 4.);
  const auto n_samples =
      static_cast<std::size_t>((largest_radius(source.body, axis) - innermost) / step) + 2;
  const ColumnMap start(grid.n_rows, grid.n_columns, innermost);
  const Profiles profiles = sample_profiles(source, grid, start, step, n_samples);
  const FrontTissue tissue = find_front_tissue(profiles, false);
  const auto darkest = double(source.scaled(signal * float(source.air)));
  Counts counts;
  for (std::size_t r = 0; r < grid.n_rows; ++r)
    for (std::size_t c = 0; c < grid.n_columns; ++c)
      if (std::abs(grid.angle(c)) < widest_breast && !std::isnan(tissue.skin(r, c)))
        counts.add(profiles, tissue, r, c, darkest);
  const double n = counts.brighter + counts.darker;
  return n > 0. ? (counts.darker - counts.brighter) / n : 0.;
}

} // namespace prosup::prepare
