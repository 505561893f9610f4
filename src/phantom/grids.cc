#include "prosup/phantom/grids.h"

#include <cmath>

#include "prosup/core/error.h"

namespace prosup::phantom {

using image::Tensor;
using image::VoxelGrid;

namespace {

constexpr double posterior_margin = 18.; // mm of chest behind the deepest tissue

/// Gives axis d of a grid as many voxels between low and high as fit best.
void fill_axis(VoxelGrid& grid, unsigned d, double low, double high, double spacing) {
  grid.size[d] = static_cast<std::size_t>(std::max(1l, std::lround((high - low) / spacing)));
  grid.spacing[d] = (high - low) / double(grid.size[d]);
  grid.origin[d] = low + 0.5 * grid.spacing[d];
}

Tensor<2, 3> rotation_about(unsigned axis, double degrees) {
  Tensor<2, 3> rotation;
  const unsigned a = (axis + 1) % 3, b = (axis + 2) % 3;
  const double angle = degrees * M_PI / 180.;
  rotation[axis][axis] = 1.;
  rotation[a][a] = rotation[b][b] = std::cos(angle);
  rotation[b][a] = std::sin(angle);
  rotation[a][b] = -std::sin(angle);
  return rotation;
}

/// Half extents of a field of view, the second given, with these axes, that lies
/// within |x| <= limit[0] and |z| <= limit[1] when centred at x = z = 0:
///   sum_e |Q_xe| h_e = limit[0],  sum_e |Q_ze| h_e = limit[1].
Tensor<1, 3> inner_half_extents(const Tensor<2, 3>& axes, const std::array<double, 2>& limit,
                                double half_depth) {
  const auto q = [&](unsigned row, unsigned column) { return std::abs(axes[row][column]); };
  const double x = limit[0] - q(0, 1) * half_depth, z = limit[1] - q(2, 1) * half_depth;
  const double determinant = q(0, 0) * q(2, 2) - q(0, 2) * q(2, 0);
  return Tensor<1, 3>({(x * q(2, 2) - z * q(0, 2)) / determinant, half_depth,
                       (z * q(0, 0) - x * q(2, 0)) / determinant});
}

} // namespace

VoxelGrid meshing_grid(const Geometry& geometry, double spacing) {
  const double margin = 4. * spacing;
  VoxelGrid grid;
  fill_axis(grid, 0, -0.5 * geometry.width, 0.5 * geometry.width, spacing);
  fill_axis(grid, 1, geometry.skin_y(0., 0.) - margin,
            geometry.chest_y(0.5 * geometry.width) + margin, spacing);
  fill_axis(grid, 2, -0.5 * geometry.length, 0.5 * geometry.length, spacing);
  return grid;
}

VoxelGrid image_grid(const Geometry& geometry, const ImagingParameters& images, Position position) {
  const bool supine = position == Position::supine;
  const double front = geometry.skin_y(0., 0.) - images.anterior_margin;
  const double back = geometry.chest_y(0.5 * geometry.width) + posterior_margin;
  const double crop = supine ? images.supine_crop : 0.;
  const Tensor<1, 3> offset = supine ? images.supine_offset : Tensor<1, 3>();

  VoxelGrid grid;
  grid.direction = rotation_about(2, images.rotation[2]) * rotation_about(1, images.rotation[1]) *
                   rotation_about(0, images.rotation[0]);
  Tensor<1, 3> half = inner_half_extents(
      grid.direction, {0.5 * geometry.width, 0.5 * geometry.length}, 0.5 * (back - front));
  for (const unsigned d : {0u, 2u})
    half[d] -= crop + std::abs(offset[d]);
  if (!(half[0] > geometry.width / 6.) || !(half[2] > geometry.length / 6.))
    throw Error("The field of view of the phantom's images would show less than a third of its "
                "width or length; choose smaller angles in 'Phantom/Images/Rotation', or a smaller "
                "'Supine crop' or 'Supine offset' there.");
  Tensor<1, 3> to_first;
  for (unsigned d = 0; d < 3; ++d) {
    grid.spacing[d] = images.voxel_edge;
    grid.size[d] = static_cast<std::size_t>(2. * half[d] / images.voxel_edge) + 1;
    to_first[d] = offset[d] - 0.5 * images.voxel_edge * double(grid.size[d] - 1);
  }
  grid.origin = Point<3>(0., 0.5 * (front + back), 0.) + grid.direction * to_first;
  return grid;
}

} // namespace prosup::phantom
