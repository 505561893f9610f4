#ifndef PROSUP_PREPARE_TRUNK_H
#define PROSUP_PREPARE_TRUNK_H

#include <cstddef>
#include <vector>

#include "prosup/image/voxel_image.h"

namespace prosup::prepare {

using image::Point;

/// Cylindrical coordinates of the trunk: r is the distance from an axis that runs from feet to head
/// inside the chest, theta the angle about it, 0 to anterior and positive to the patient's left:
///   x = axis_x + r sin(theta),  y = axis_y - r cos(theta)   (LPS, mm).
/// The front of the chest is nearly r = constant in them.
struct TrunkAxis {
  double x = 0., y = 0.; ///< mm
  double front = 0.;     ///< y at which the breasts end and the chest begins, mm

  double radius(const Point<3>& p) const;
  double angle(const Point<3>& p) const; ///< rad
  Point<3> position(double radius, double angle, double z) const;
};

/// The axis of a body: in the middle between its sides, 120 mm behind the coronal plane in which,
/// seen from the front, the area of the body is 0.6 of the largest. The breasts in front of that
/// plane are narrower.
TrunkAxis find_trunk_axis(const image::LabelImage& body);

/// Largest distance of a body from the axis, mm.
double largest_radius(const image::LabelImage& body, const TrunkAxis& axis);

/// Breasts lie within this angle to both sides of the front, rad.
inline constexpr double widest_breast = 1.;

/// A grid of columns along r, each at an angle and a height z.
struct TrunkGrid {
  TrunkAxis axis;
  double first_angle = 0., angle_step = 1.; ///< rad
  double first_z = 0., z_step = 1.;         ///< mm
  std::size_t n_rows = 0;                   ///< along z
  std::size_t n_columns = 0;                ///< along the angle

  double angle(std::size_t column) const { return first_angle + double(column) * angle_step; }
  double z(std::size_t row) const { return first_z + double(row) * z_step; }
};

/// Columns over all heights of an image and 75 degrees to both sides.
TrunkGrid trunk_grid(const TrunkAxis& axis, const image::VoxelGrid& image, double angle_step,
                     double z_step);

/// A surface r(theta, z).
struct TrunkSurface {
  TrunkGrid grid;
  std::vector<double> radius; ///< of each column, row by row, mm

  /// Interpolated; outside of the grid that of its border.
  double operator()(double angle, double z) const;
};

} // namespace prosup::prepare

#endif
