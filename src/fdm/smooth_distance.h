#ifndef PROSUP_SRC_FDM_SMOOTH_DISTANCE_H
#define PROSUP_SRC_FDM_SMOOTH_DISTANCE_H

#include "prosup/fdm/vector_field.h"
#include "prosup/image/voxel_image.h"

namespace prosup::fdm {

/// Signed distance from the surface of a label, negative inside, by quadratic B-splines:
/// its gradient is continuous. By that of a trilinear interpolant surfaces have edges, on
/// which nodes that slide get caught.
class SmoothDistance {
public:
  SmoothDistance() = default;
  /// Splines half as wide as `spacing`, from `low` to `high`; beyond, the distance goes on
  /// as it is at the nearest place between. The stairs of the voxels are smoothed away.
  SmoothDistance(const image::LabelImage& labels, unsigned label, const Point<3>& low,
                 const Point<3>& high, double spacing);

  /// Distance, mm, and its unit normal (zero where there is none).
  double value(const Point<3>& position, Tensor<1, 3>& normal) const;

private:
  image::ScalarImage coefficients_;
};

} // namespace prosup::fdm

#endif
