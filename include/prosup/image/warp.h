#ifndef PROSUP_IMAGE_WARP_H
#define PROSUP_IMAGE_WARP_H

#include <string>
#include <vector>

#include "prosup/image/rigid_transform.h"
#include "prosup/image/voxel_image.h"

namespace prosup::image {

/// How an image is interpolated between its voxels.
enum class Interpolation { linear, nearest, bspline };

/// Their names: linear, nearest, bspline (cubic).
const std::vector<std::string>& interpolation_names();
/// @throws Error that lists the names if `name` is none of them.
Interpolation interpolation_of(const std::string& name);

/// Resamples `image` on the grid of the displacement u: the result at X is image(X + u(X)), or
/// `outside` if X + u(X) lies outside the field of view of `image`. Other than linear by ITK.
ScalarImage warp(const ScalarImage& image, const VectorImage& displacement,
                 Interpolation interpolation, float outside);

/// A displacement field at any point: linear between its voxels, and the rigid motion `beyond`
/// outside of the centres of its border voxels.
class FieldSampler {
public:
  /// Keeps a reference to the field.
  FieldSampler(const VectorImage& field, const RigidTransform& beyond);

  Tensor<1, 3> operator()(const Point<3>& point) const;

private:
  const VectorImage& field_;
  RigidTransform beyond_;
};

/// The field on another grid of the same space.
VectorImage resampled(const VectorImage& field, const VoxelGrid& grid,
                      const RigidTransform& beyond);

} // namespace prosup::image

#endif
