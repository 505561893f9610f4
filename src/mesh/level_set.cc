#include "level_set.h"

#include <algorithm>
#include <cmath>

#include "prosup/image/filters.h"

namespace prosup::mesh {

namespace {

using image::LabelImage;
using image::ScalarImage;
using image::VoxelGrid;

/// First voxel of a box and the first beyond it.
struct VoxelBox {
  std::array<std::size_t, 3> begin, end;
};

VoxelBox bounding_box(const LabelImage& mask) {
  VoxelBox box{mask.grid.size, {0, 0, 0}};
  for (std::size_t k = 0, v = 0; k < mask.grid.size[2]; ++k)
    for (std::size_t j = 0; j < mask.grid.size[1]; ++j)
      for (std::size_t i = 0; i < mask.grid.size[0]; ++i, ++v)
        if (mask.values[v]) {
          const std::size_t index[3] = {i, j, k};
          for (unsigned d = 0; d < 3; ++d) {
            box.begin[d] = std::min(box.begin[d], index[d]);
            box.end[d] = std::max(box.end[d], index[d] + 1);
          }
        }
  return box;
}

/// Extends a box by `margin_mm`, but not beyond the image.
VoxelBox with_margin(VoxelBox box, const VoxelGrid& grid, double margin_mm) {
  for (unsigned d = 0; d < 3; ++d) {
    const auto margin = std::size_t(std::ceil(margin_mm / grid.spacing[d]));
    box.begin[d] -= std::min(margin, box.begin[d]);
    box.end[d] = std::min(grid.size[d], box.end[d] + margin);
  }
  return box;
}

/// Cuts out a box, on a grid whose axes are the coordinate axes and whose
/// origin is that of the whole image.
LabelImage cut_out(const LabelImage& mask, const VoxelBox& box) {
  VoxelGrid grid;
  grid.spacing = mask.grid.spacing;
  for (unsigned d = 0; d < 3; ++d) {
    grid.size[d] = box.end[d] - box.begin[d];
    grid.origin[d] = grid.spacing[d] * double(box.begin[d]);
  }
  LabelImage result(grid);
  for (std::size_t k = 0; k < grid.size[2]; ++k)
    for (std::size_t j = 0; j < grid.size[1]; ++j)
      std::copy_n(&mask(box.begin[0], box.begin[1] + j, box.begin[2] + k), grid.size[0],
                  &result(0, j, k));
  return result;
}

double margin_mm(const VoxelGrid& grid, double sigma_mm) {
  const double largest = std::max({grid.spacing[0], grid.spacing[1], grid.spacing[2]});
  return 3. * (largest + sigma_mm);
}

ScalarImage smooth_distance(const LabelImage& mask, double sigma_mm) {
  const LabelImage part =
      cut_out(mask, with_margin(bounding_box(mask), mask.grid, margin_mm(mask.grid, sigma_mm)));
  // A mask that fills its image has no boundary to be distant from.
  if (std::find(part.values.begin(), part.values.end(), 0) == part.values.end())
    return image::extended(ScalarImage(part.grid, -float(margin_mm(mask.grid, sigma_mm))), 1);
  return image::extended(image::gaussian_smooth(image::signed_distance(part), sigma_mm), 1);
}

} // namespace

LevelSet::LevelSet(const LabelImage& mask, double sigma_mm)
    : distance_(smooth_distance(mask, sigma_mm)), sampler_(distance_), sigma_(sigma_mm) {
  const VoxelGrid& grid = distance_.grid;
  for (unsigned d = 0; d < 3; ++d) {
    box_[0][d] = grid.origin[d] + 0.5 * grid.spacing[d];
    box_[1][d] = grid.origin[d] + grid.spacing[d] * (double(grid.size[d]) - 1.5);
  }
  mask_volume_ = grid.voxel_volume() * double(std::count_if(mask.values.begin(), mask.values.end(),
                                                            [](auto v) { return v != 0; }));
}

} // namespace prosup::mesh
