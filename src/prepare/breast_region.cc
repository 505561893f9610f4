#include "prosup/prepare/breast_region.h"

#include <algorithm>
#include <cmath>

#include "prosup/core/error.h"
#include "prosup/core/log.h"
#include "prosup/prepare/body_outline.h"

namespace prosup::prepare {

namespace {

using image::LabelImage;
using image::VoxelGrid;

/// Whether a column of tissue belongs to a breast.
bool is_breast(const Point<3>& p, const TrunkSurface& chest) {
  const TrunkAxis& axis = chest.grid.axis;
  return axis.radius(p) - chest(axis.angle(p), p[2]) > least_breast_thickness;
}

bool is_on_side(const Point<3>& p, const TrunkAxis& axis, Side side) {
  return side == Side::both || (p[0] > axis.x) == (side == Side::left);
}

VoxelBox whole(const VoxelGrid& grid) {
  return {{0, 0, 0}, grid.size};
}

/// The box of the voxels of a breast; empty if there are none.
VoxelBox tight_box(const LabelImage& front, const TrunkSurface& chest, Side side) {
  VoxelBox box{front.grid.size, {0, 0, 0}};
  const auto& size = front.grid.size;
  for (std::size_t k = 0; k < size[2]; ++k)
    for (std::size_t j = 0; j < size[1]; ++j)
      for (std::size_t i = 0; i < size[0]; ++i) {
        if (front(i, j, k) == 0)
          continue;
        const Point<3> p = front.grid.physical(double(i), double(j), double(k));
        if (!is_on_side(p, chest.grid.axis, side) || !is_breast(p, chest))
          continue;
        const std::size_t at[3] = {i, j, k};
        for (unsigned d = 0; d < 3; ++d) {
          box.first[d] = std::min(box.first[d], at[d]);
          box.end[d] = std::max(box.end[d], at[d] + 1);
        }
      }
  return box;
}

/// Adds the margin; behind, the image is kept to its border, for the chest.
VoxelBox with_margin(VoxelBox box, const VoxelGrid& grid, double margin) {
  for (unsigned d = 0; d < 3; ++d) {
    const auto n = static_cast<std::size_t>(std::ceil(margin / grid.spacing[d]));
    box.first[d] = box.first[d] > n ? box.first[d] - n : 0;
    box.end[d] = std::min(box.end[d] + n, grid.size[d]);
  }
  (front_is_first(grid) ? box.end[1] : box.first[1]) = front_is_first(grid) ? grid.size[1] : 0;
  return box;
}

template <typename T>
image::VoxelImage<T> part_of(const image::VoxelImage<T>& image, const VoxelBox& box) {
  VoxelGrid grid = image.grid;
  grid.origin =
      image.grid.physical(double(box.first[0]), double(box.first[1]), double(box.first[2]));
  for (unsigned d = 0; d < 3; ++d)
    grid.size[d] = box.end[d] - box.first[d];
  image::VoxelImage<T> part(grid);
  for (std::size_t k = 0; k < grid.size[2]; ++k)
    for (std::size_t j = 0; j < grid.size[1]; ++j)
      std::copy_n(&image(box.first[0], box.first[1] + j, box.first[2] + k), grid.size[0],
                  &part(0, j, k));
  return part;
}

} // namespace

const std::vector<std::string>& side_names() {
  static const std::vector<std::string> names{"both", "left", "right"};
  return names;
}

VoxelBox breast_box(const LabelImage& front, const TrunkSurface& chest, Side side, double margin) {
  const VoxelBox box = tight_box(front, chest, side);
  if (box.end[0] == 0)
    throw Error(
        format("No breast is found%s: nowhere is there more than %.0f mm of tissue in front "
               "of the chest; choose the other side, or give a scan that shows the breast.",
               side == Side::both   ? ""
               : side == Side::left ? " on the patient's left"
                                    : " on the patient's right",
               least_breast_thickness));
  return side == Side::both ? whole(front.grid) : with_margin(box, front.grid, margin);
}

void require_whole_front(const LabelImage& front) {
  constexpr double largest_area = 400.; // mm^2
  const auto& size = front.grid.size;
  const std::size_t j = front_is_first(front.grid) ? 0 : size[1] - 1;
  std::size_t n = 0;
  for (std::size_t k = 0; k < size[2]; ++k)
    for (std::size_t i = 0; i < size[0]; ++i)
      n += front(i, j, k) != 0;
  const double area = double(n) * front.grid.spacing[0] * front.grid.spacing[2];
  if (area > largest_area)
    throw Error(format("The breast is cut off by the front border of the image, where %.1f cm^2 of "
                       "tissue are; give a scan with the whole breast in its field of view.",
                       area / 100.));
}

image::ScalarImage cropped(const image::ScalarImage& image, const VoxelBox& box) {
  return part_of(image, box);
}

LabelImage cropped(const LabelImage& image, const VoxelBox& box) {
  return part_of(image, box);
}

} // namespace prosup::prepare
