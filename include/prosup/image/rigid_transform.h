#ifndef PROSUP_IMAGE_RIGID_TRANSFORM_H
#define PROSUP_IMAGE_RIGID_TRANSFORM_H

#include "prosup/image/voxel_image.h"

namespace prosup::image {

/// A rotation R about a centre c and a translation t:  T(x) = R (x - c) + c + t, LPS, mm. By
/// default the identity.
struct RigidTransform {
  Tensor<2, 3> rotation{{{1., 0., 0.}, {0., 1., 0.}, {0., 0., 1.}}};
  Point<3> centre;
  Tensor<1, 3> translation; ///< displacement of the centre, mm

  Point<3> operator()(const Point<3>& x) const {
    return centre + translation + rotation * (x - centre);
  }

  /// The inverse, with the same centre.
  RigidTransform inverse() const;

  /// The grid of a moved image: its voxel i is at T(x_i).
  VoxelGrid operator()(const VoxelGrid& grid) const;

  /// Axis of the rotation times its angle in radians.
  Tensor<1, 3> rotation_vector() const;
};

/// The transform outer(inner(x)), with the centre of `inner`.
RigidTransform compose(const RigidTransform& outer, const RigidTransform& inner);

/// A small rigid motion, such as a step of a search: a rotation vector in radians and a
/// translation in mm.
struct RigidMotion {
  Tensor<1, 3> rotation, translation;

  RigidMotion& add(double factor, const RigidMotion& other) {
    rotation += factor * other.rotation;
    translation += factor * other.translation;
    return *this;
  }

  /// The transform with this motion, whose rotation is about `centre`.
  RigidTransform about(const Point<3>& centre) const;
};

/// Rotation about the axis `vector` by its length in radians (Rodrigues' formula).
Tensor<2, 3> rotation_about(const Tensor<1, 3>& vector);

} // namespace prosup::image

#endif
