#ifndef PROSUP_SRC_IMAGE_REGULAR_GRID_H
#define PROSUP_SRC_IMAGE_REGULAR_GRID_H

#include "prosup/image/voxel_image.h"

namespace prosup::image {

/// Where a file says that its voxels are, LPS, mm: the centre of voxel i is at
/// origin + sum_d i_d steps[d].
struct VoxelSteps {
  Point<3> origin;
  std::array<Tensor<1, 3>, 3> steps;

  Point<3> physical(const std::array<double, 3>& index) const {
    return origin + index[0] * steps[0] + index[1] * steps[1] + index[2] * steps[2];
  }
};

/// Makes the direction cosines of a grid orthonormal to rounding, since files hold them with few
/// digits.
/// @throws std::domain_error if they are further from orthonormal than that; its text continues
/// "its ".
void make_orthonormal(Tensor<2, 3>& direction);

/// The grid of voxels at `steps`. @throws std::domain_error as make_orthonormal(), or if a step has
/// no length.
VoxelGrid regular_grid(const std::array<std::size_t, 3>& size, const VoxelSteps& steps);

} // namespace prosup::image

#endif
