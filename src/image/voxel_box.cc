#include "prosup/image/voxel_box.h"

#include <cmath>

namespace prosup::image {

void VoxelBox::include(std::size_t i, std::size_t j, std::size_t k) {
  const std::size_t index[3] = {i, j, k};
  for (unsigned d = 0; d < 3; ++d) {
    begin[d] = std::min(begin[d], index[d]);
    end[d] = std::max(end[d], index[d] + 1);
  }
}

VoxelBox bounding_box(const LabelImage& mask) {
  VoxelBox box;
  for (std::size_t k = 0, v = 0; k < mask.grid.size[2]; ++k)
    for (std::size_t j = 0; j < mask.grid.size[1]; ++j)
      for (std::size_t i = 0; i < mask.grid.size[0]; ++i, ++v)
        if (mask.values[v] != 0)
          box.include(i, j, k);
  return box;
}

VoxelBox with_margin(VoxelBox box, const VoxelGrid& grid, double margin_mm) {
  for (unsigned d = 0; d < 3; ++d) {
    const auto margin = static_cast<std::size_t>(std::ceil(margin_mm / grid.spacing[d]));
    box.begin[d] -= std::min(margin, box.begin[d]);
    box.end[d] = std::min(grid.size[d], box.end[d] + margin);
  }
  return box;
}

VoxelGrid part_of(const VoxelGrid& grid, const VoxelBox& box) {
  VoxelGrid part = grid;
  part.origin = grid.physical(double(box.begin[0]), double(box.begin[1]), double(box.begin[2]));
  for (unsigned d = 0; d < 3; ++d)
    part.size[d] = box.end[d] - box.begin[d];
  return part;
}

} // namespace prosup::image
