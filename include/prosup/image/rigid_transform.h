#ifndef PROSUP_IMAGE_RIGID_TRANSFORM_H
#define PROSUP_IMAGE_RIGID_TRANSFORM_H

#include "prosup/image/voxel_image.h"

namespace prosup::image {

/// A rotation R about a centre c and a translation t:  T(x) = R (x - c) + c + t;
/// LPS, mm. The identity unless told otherwise.
struct RigidTransform {
  Tensor<2, 3> rotation{{{1., 0., 0.}, {0., 1., 0.}, {0., 0., 1.}}};
  Point<3> centre;
  Tensor<1, 3> translation; ///< displacement of the centre, mm

  Point<3> operator()(const Point<3>& x) const {
    return centre + translation + rotation * (x - centre);
  }

  /// Its centre is the same.
  RigidTransform inverse() const;

  /// The grid that lies on a moved image: voxel i of it is at T(x_i).
  VoxelGrid operator()(const VoxelGrid& grid) const;

  /// Axis of the rotation times its angle, radians.
  Tensor<1, 3> rotation_vector() const;
};

/// x -> outer(inner(x)), about the centre of `inner`.
RigidTransform compose(const RigidTransform& outer, const RigidTransform& inner);

/// A small rigid motion, as a step of a search: a rotation vector, radians, and a
/// translation, mm.
struct RigidMotion {
  Tensor<1, 3> rotation, translation;

  RigidMotion& add(double factor, const RigidMotion& other) {
    rotation += factor * other.rotation;
    translation += factor * other.translation;
    return *this;
  }

  /// Its rotation is about `centre`.
  RigidTransform about(const Point<3>& centre) const;
};

/// The rotation about `vector` by its length, radians (Rodrigues' formula).
Tensor<2, 3> rotation_about(const Tensor<1, 3>& vector);

} // namespace prosup::image

#endif
