#include "prosup/prepare/unknown_region.h"

#include <algorithm>
#include <limits>

#include "boxes.h"
#include "flood.h"
#include "prosup/image/filters.h"

namespace prosup::prepare {

namespace {

using image::LabelImage;
using image::ScalarImage;

constexpr double thinnest = 2.;      // mm, half of the width
constexpr double least_contact = 2.; // cm^2
constexpr double most_of_the_air = 0.9;

/// What hangs together with the border of the image.
LabelImage at_border(const LabelImage& mask) {
  LabelImage reached(mask.grid);
  const auto& size = mask.grid.size;
  for (std::size_t k = 0; k < size[2]; ++k)
    for (std::size_t j = 0; j < size[1]; ++j)
      for (std::size_t i = 0; i < size[0]; ++i) {
        const bool is_border =
            i == 0 || j == 0 || k == 0 || i + 1 == size[0] || j + 1 == size[1] || k + 1 == size[2];
        reached(i, j, k) = is_border && mask(i, j, k) != 0;
      }
  flood(reached, mask, std::numeric_limits<double>::infinity());
  return reached;
}

/// Area of the voxel faces between both masks, cm^2.
double contact(const LabelImage& a, const LabelImage& b) {
  const image::VoxelGrid& grid = a.grid;
  const std::size_t stride[3] = {1, grid.size[0], grid.size[0] * grid.size[1]};
  double area = 0.; // mm^2
  std::size_t v = 0;
  for (std::size_t k = 0; k < grid.size[2]; ++k)
    for (std::size_t j = 0; j < grid.size[1]; ++j)
      for (std::size_t i = 0; i < grid.size[0]; ++i, ++v) {
        const std::size_t at[3] = {i, j, k};
        for (unsigned d = 0; d < 3; ++d) {
          if (at[d] + 1 == grid.size[d])
            continue;
          const std::size_t w = v + stride[d];
          if ((a.values[v] != 0 && b.values[w] != 0) || (a.values[w] != 0 && b.values[v] != 0))
            area += grid.voxel_volume() / grid.spacing[d];
        }
      }
  return area / 100.;
}

} // namespace

std::optional<UnknownRegion> find_unknown(const ScalarImage& scan, const LabelImage& body) {
  UnknownRegion region;
  const float least = *std::min_element(scan.values.begin(), scan.values.end());
  LabelImage constant(scan.grid);
  for (std::size_t v = 0; v < scan.values.size(); ++v)
    constant.values[v] = scan.values[v] == least;
  region.value = double(least);
  region.mask = at_border(opened(constant, thinnest));
  LabelImage tissue(scan.grid);
  std::size_t n_others = 0, n_unknown = 0;
  for (std::size_t v = 0; v < scan.values.size(); ++v) {
    const bool is_unknown = region.mask.values[v] != 0;
    tissue.values[v] = body.values[v] != 0 && constant.values[v] == 0;
    n_others += tissue.values[v] == 0;
    n_unknown += is_unknown;
  }
  if (n_unknown == 0 || double(n_unknown) > most_of_the_air * double(n_others))
    return std::nullopt;
  region.contact = contact(region.mask, tissue);
  if (region.contact < least_contact)
    return std::nullopt;
  return region;
}

} // namespace prosup::prepare
