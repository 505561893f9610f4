#include "user_masks.h"

#include <algorithm>
#include <cmath>

#include "body_parts.h"
#include "chest_shape.h"
#include "prosup/core/error.h"
#include "prosup/image/sampling.h"

namespace prosup::prepare {

namespace {

using image::LabelImage;

constexpr double degree = 3.14159265358979323846 / 180.;
constexpr double sample_step = 0.5; // mm

std::optional<LabelImage> on_grid(const std::optional<LabelImage>& mask,
                                  const image::VoxelGrid& grid, const char* what) {
  if (!mask)
    return {};
  LabelImage result(grid);
  std::size_t v = 0, n = 0;
  for (std::size_t k = 0; k < grid.size[2]; ++k)
    for (std::size_t j = 0; j < grid.size[1]; ++j)
      for (std::size_t i = 0; i < grid.size[0]; ++i, ++v) {
        result.values[v] =
            image::nearest_label(*mask, grid.physical(double(i), double(j), double(k))) != 0;
        n += result.values[v];
      }
  if (n == 0)
    throw Error(std::string("The mask of the ") + what +
                " marks no voxel of the scan; give one that is drawn on this scan, in the same "
                "coordinates.");
  return result;
}

/// Distance from the axis to the furthest corner of a grid, mm.
double furthest(const image::VoxelGrid& grid, const TrunkAxis& axis) {
  double radius = 0.;
  for (unsigned corner = 0; corner < 8; ++corner) {
    const auto end = [&](unsigned d) {
      return corner & (1u << d) ? double(grid.size[d]) - 1. : 0.;
    };
    radius = std::max(radius, axis.radius(grid.physical(end(0), end(1), end(2))));
  }
  return radius;
}

} // namespace

UserMasks on_grid(const UserMasks& masks, const image::VoxelGrid& scan) {
  return {on_grid(masks.chest, scan, "chest"), on_grid(masks.breast, scan, "breast"),
          on_grid(masks.gland, scan, "gland")};
}

ChestWall wall_of_mask(const LabelImage& chest, const TrunkAxis& axis, const FatSign& fat) {
  ChestWall wall;
  wall.fat = fat;
  const TrunkGrid grid = trunk_grid(axis, chest.grid, degree, 2.);
  const double last = furthest(chest.grid, axis);
  ColumnMap radius(grid.n_rows, grid.n_columns);
  std::vector<char> known(radius.values.size(), 0), unknown(radius.values.size(), 1);
  for (std::size_t column = 0; column < known.size(); ++column)
    for (double r = last; r > 0. && known[column] == 0; r -= sample_step) {
      const std::size_t row = column / grid.n_columns, at = column % grid.n_columns;
      if (image::nearest_label(chest, axis.position(r, grid.angle(at), grid.z(row))) == 0)
        continue;
      radius.values[column] = r;
      known[column] = 1;
      unknown[column] = 0;
    }
  const ColumnMap smooth = smooth_chest(grid, radius, known);
  for (std::size_t column = 0; column < known.size(); ++column)
    if (known[column] == 0)
      radius.values[column] = smooth.values[column];
  bridge(radius, unknown);
  wall.surface = {grid, radius.values};
  return wall;
}

Tissues tissues_of_mask(const TissueImage& image, const LabelImage& parts,
                        const LabelImage& gland) {
  Tissues tissues;
  tissues.gland = LabelImage(gland.grid);
  tissues.fraction = image::ScalarImage(gland.grid);
  double n[2] = {0., 0.}, sum[2] = {0., 0.}, squares = 0.;
  for (std::size_t v = 0; v < gland.values.size(); ++v) {
    const bool is_gland = gland.values[v] != 0 && parts.values[v] == in_front_of_wall;
    tissues.gland.values[v] = is_gland;
    tissues.fraction.values[v] = is_gland ? 1.f : 0.f;
    if (image.inner.values[v] == 0)
      continue;
    const double value = double(image.image.values[v]);
    n[is_gland] += 1.;
    sum[is_gland] += value;
    squares += value * value;
  }
  tissues.fat = sum[0] / std::max(n[0], 1.);
  tissues.gland_intensity = sum[1] / std::max(n[1], 1.);
  const double variance = (squares - n[0] * tissues.fat * tissues.fat -
                           n[1] * tissues.gland_intensity * tissues.gland_intensity) /
                          std::max(n[0] + n[1], 1.);
  tissues.deviation = std::sqrt(std::max(variance, 1e-12));
  return tissues;
}

} // namespace prosup::prepare
