#include "prosup/image/voxel_image.h"

#include <cmath>

namespace prosup::image {

Point<3> VoxelGrid::physical(double i, double j, double k) const {
  const Tensor<1, 3> along_axes({i * spacing[0], j * spacing[1], k * spacing[2]});
  return origin + direction * along_axes;
}

Point<3> VoxelGrid::continuous_index(const Point<3>& position) const {
  // `direction` is orthonormal: its transpose is its inverse.
  const Tensor<1, 3> along_axes = (position - origin) * direction;
  return Point<3>(along_axes[0] / spacing[0], along_axes[1] / spacing[1],
                  along_axes[2] / spacing[2]);
}

bool VoxelGrid::coincides_with(const VoxelGrid& other, double tolerance) const {
  if (size != other.size)
    return false;
  // The index maps are affine: what holds at the corners holds in between.
  for (unsigned corner = 0; corner < 8; ++corner) {
    double index[3];
    for (unsigned d = 0; d < 3; ++d)
      index[d] = (corner >> d & 1u) && size[d] > 0 ? double(size[d] - 1) : 0.;
    const Point<3> seen = continuous_index(other.physical(index[0], index[1], index[2]));
    for (unsigned d = 0; d < 3; ++d)
      if (!(std::abs(seen[d] - index[d]) <= tolerance))
        return false;
  }
  return true;
}

VoxelGrid grid_around(const Point<3>& low, const Point<3>& high, double spacing, double margin) {
  VoxelGrid grid;
  for (unsigned d = 0; d < 3; ++d) {
    const double first = std::floor((low[d] - margin) / spacing);
    const double last = std::ceil((high[d] + margin) / spacing);
    grid.spacing[d] = spacing;
    grid.origin[d] = spacing * first;
    grid.size[d] = static_cast<std::size_t>(last - first) + 1;
  }
  return grid;
}

} // namespace prosup::image
