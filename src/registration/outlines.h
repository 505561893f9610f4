#ifndef PROSUP_SRC_REGISTRATION_OUTLINES_H
#define PROSUP_SRC_REGISTRATION_OUTLINES_H

#include <array>
#include <vector>

#include "prosup/image/voxel_image.h"

namespace prosup::registration {

/// Calls `visit(v, w)` for each pair of neighbours v < w of a grid, linear indices.
template <typename Visit>
void for_each_neighbours(const image::VoxelGrid& grid, Visit&& visit) {
  const std::array<std::size_t, 3> stride{1, grid.size[0], grid.size[0] * grid.size[1]};
  std::size_t v = 0;
  for (std::size_t k = 0; k < grid.size[2]; ++k)
    for (std::size_t j = 0; j < grid.size[1]; ++j)
      for (std::size_t i = 0; i < grid.size[0]; ++i, ++v) {
        const std::array<std::size_t, 3> index{i, j, k};
        for (unsigned d = 0; d < 3; ++d)
          if (index[d] + 1 < grid.size[d])
            visit(v, v + stride[d]);
      }
}

/// image::signed_distance() of a mask; empty if the mask is empty or fills its grid.
image::ScalarImage distance_to(const image::LabelImage& mask);

} // namespace prosup::registration

#endif
