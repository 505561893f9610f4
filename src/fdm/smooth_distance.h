#ifndef PROSUP_SRC_FDM_SMOOTH_DISTANCE_H
#define PROSUP_SRC_FDM_SMOOTH_DISTANCE_H

#include "prosup/fdm/vector_field.h"
#include "prosup/image/voxel_image.h"

namespace prosup::fdm {

/// Signed distance from the surface of a label, negative inside, by quadratic B-splines,
/// which have a continuous gradient. The surfaces of a trilinear interpolant have edges, on
/// which sliding nodes get caught.
class SmoothDistance {
public:
  SmoothDistance() = default;
  /// Knots at half of `spacing`, from `low` to `high`. Beyond that box the distance is that
  /// of the nearest point in it. The stairs of the voxels are smoothed away.
  SmoothDistance(const image::LabelImage& labels, unsigned label, const Point<3>& low,
                 const Point<3>& high, double spacing);

  /// Distance, mm, and its unit normal (zero where the gradient vanishes).
  double value(const Point<3>& position, Tensor<1, 3>& normal) const;

private:
  image::ScalarImage coefficients_;
};

} // namespace prosup::fdm

#endif
