#include "prosup/image/rigid_transform.h"

#include <algorithm>
#include <cmath>

namespace prosup::image {

using namespace dealii;

RigidTransform RigidTransform::inverse() const {
  RigidTransform result;
  result.rotation = transpose(rotation);
  result.centre = centre;
  result.translation = -1. * (result.rotation * translation);
  return result;
}

VoxelGrid RigidTransform::operator()(const VoxelGrid& grid) const {
  VoxelGrid result = grid;
  result.origin = (*this)(grid.origin);
  result.direction = rotation * grid.direction;
  return result;
}

Tensor<1, 3> RigidTransform::rotation_vector() const {
  // The antisymmetric part is sin(angle) times the axis. That is small near half
  // a turn, which no alignment of two chests comes close to.
  const Tensor<2, 3>& r = rotation;
  const Tensor<1, 3> sine({r[2][1] - r[1][2], r[0][2] - r[2][0], r[1][0] - r[0][1]});
  const double sin_angle = 0.5 * sine.norm(), cos_angle = 0.5 * (trace(r) - 1.);
  const double angle = std::atan2(sin_angle, cos_angle);
  return sin_angle > 1e-12 ? 0.5 * angle / sin_angle * sine : Tensor<1, 3>();
}

RigidTransform compose(const RigidTransform& outer, const RigidTransform& inner) {
  RigidTransform result;
  result.rotation = outer.rotation * inner.rotation;
  result.centre = inner.centre;
  result.translation = outer(inner(inner.centre)) - inner.centre;
  return result;
}

RigidTransform RigidMotion::about(const Point<3>& centre) const {
  RigidTransform transform;
  transform.rotation = rotation_about(rotation);
  transform.centre = centre;
  transform.translation = translation;
  return transform;
}

Tensor<2, 3> rotation_about(const Tensor<1, 3>& vector) {
  const double angle = vector.norm();
  const Tensor<1, 3> axis = vector / std::max(angle, 1e-300);
  Tensor<2, 3> result;
  for (unsigned d = 0; d < 3; ++d) {
    Tensor<1, 3> unit;
    unit[d] = 1.;
    const Tensor<1, 3> column = std::cos(angle) * unit +
                                std::sin(angle) * cross_product_3d(axis, unit) +
                                (1. - std::cos(angle)) * axis[d] * axis;
    for (unsigned e = 0; e < 3; ++e)
      result[e][d] = column[e];
  }
  return result;
}

} // namespace prosup::image
