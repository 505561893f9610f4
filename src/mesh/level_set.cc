#include "level_set.h"

#include <algorithm>
#include <cmath>

#include "prosup/image/filters.h"
#include "prosup/image/voxel_box.h"

namespace prosup::mesh {

namespace {

using image::LabelImage;
using image::ScalarImage;
using image::VoxelBox;
using image::VoxelGrid;

/// Cuts out a box, on a grid whose axes are the coordinate axes and whose
/// origin is that of the whole image.
LabelImage cut_out(const LabelImage& mask, const VoxelBox& box) {
  LabelImage result = image::part_of(mask, box);
  VoxelGrid grid;
  grid.size = result.grid.size;
  grid.spacing = mask.grid.spacing;
  for (unsigned d = 0; d < 3; ++d)
    grid.origin[d] = grid.spacing[d] * double(box.begin[d]);
  result.grid = grid;
  return result;
}

double margin_mm(const VoxelGrid& grid, double sigma_mm) {
  const double largest = std::max({grid.spacing[0], grid.spacing[1], grid.spacing[2]});
  return 3. * (largest + sigma_mm);
}

ScalarImage smooth_distance(const LabelImage& mask, double sigma_mm) {
  const LabelImage part = cut_out(mask, image::with_margin(image::bounding_box(mask), mask.grid,
                                                           margin_mm(mask.grid, sigma_mm)));
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
