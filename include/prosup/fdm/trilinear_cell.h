#ifndef PROSUP_FDM_TRILINEAR_CELL_H
#define PROSUP_FDM_TRILINEAR_CELL_H

#include <algorithm>
#include <cstddef>

#include "prosup/image/voxel_image.h"

namespace prosup::fdm {

/// The cell that contains a position, in a grid with axes along LPS and at least two
/// points in each direction, and the weights of its corners in trilinear interpolation.
/// Positions beyond the grid are moved to its border.
class TrilinearCell {
public:
  TrilinearCell(const image::VoxelGrid& grid, const dealii::Point<3>& position)
      : row_(grid.size[0]), plane_(grid.size[0] * grid.size[1]) {
    std::size_t start[3];
    for (unsigned d = 0; d < 3; ++d) {
      const double last = double(grid.size[d] - 1);
      // In this order of arguments what is not a number becomes 0.
      const double index = (position[d] - grid.origin[d]) / grid.spacing[d];
      const double clamped = std::min(std::max(0., index), last);
      start[d] = std::min(std::size_t(clamped), grid.size[d] - 2);
      t_[d] = clamped - double(start[d]);
    }
    first_ = start[0] + row_ * start[1] + plane_ * start[2];
  }

  /// Bits 0, 1 and 2 of the corner's number tell whether it is the upper one along x, y and z.
  std::size_t node(unsigned corner) const {
    return first_ + (corner & 1u) + (corner & 2u ? row_ : 0) + (corner & 4u ? plane_ : 0);
  }
  double weight(unsigned corner) const {
    return (corner & 1u ? t_[0] : 1. - t_[0]) * (corner & 2u ? t_[1] : 1. - t_[1]) *
           (corner & 4u ? t_[2] : 1. - t_[2]);
  }

private:
  std::size_t row_, plane_, first_;
  double t_[3];
};

} // namespace prosup::fdm

#endif
