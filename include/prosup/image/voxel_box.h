#ifndef PROSUP_IMAGE_VOXEL_BOX_H
#define PROSUP_IMAGE_VOXEL_BOX_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

#include "prosup/image/voxel_image.h"

namespace prosup::image {

/// Voxels from `begin` to before `end` along each axis of a grid. A new one is empty.
struct VoxelBox {
  static constexpr std::size_t nowhere = std::numeric_limits<std::size_t>::max();
  std::array<std::size_t, 3> begin{nowhere, nowhere, nowhere}, end{0, 0, 0};

  bool is_empty() const { return begin[0] >= end[0]; }
  /// Extends it to a voxel.
  void include(std::size_t i, std::size_t j, std::size_t k);
};

/// The box of the voxels where a mask is not 0.
VoxelBox bounding_box(const LabelImage& mask);

/// Extends a box by `margin_mm`, but not beyond the grid.
VoxelBox with_margin(VoxelBox box, const VoxelGrid& grid, double margin_mm);

/// The grid of the voxels of a box that lies within `grid`.
VoxelGrid part_of(const VoxelGrid& grid, const VoxelBox& box);

/// The voxels of a box that lies within the image.
template <typename T>
VoxelImage<T> part_of(const VoxelImage<T>& image, const VoxelBox& box) {
  VoxelImage<T> part(part_of(image.grid, box));
  for (std::size_t k = 0; k < part.grid.size[2]; ++k)
    for (std::size_t j = 0; j < part.grid.size[1]; ++j)
      std::copy_n(&image(box.begin[0], box.begin[1] + j, box.begin[2] + k), part.grid.size[0],
                  &part(0, j, k));
  return part;
}

} // namespace prosup::image

#endif
