#ifndef PROSUP_MESH_TRIANGLE_SHAPE_H
#define PROSUP_MESH_TRIANGLE_SHAPE_H

#include <algorithm>
#include <cmath>

#include "surface_projection.h"

namespace prosup::mesh {

using Corners3 = std::array<Point<3>, 3>;

/// Normal of a triangle, its length the area, mm^2.
inline dealii::Tensor<1, 3> area_vector(const Corners3& x) {
  return 0.5 * cross_product_3d(x[1] - x[0], x[2] - x[0]);
}

/// Area over that of the equilateral triangle on the longest side.
inline double fullness(const Corners3& x) {
  const double longest = std::max(
      {(x[1] - x[0]).norm_square(), (x[2] - x[1]).norm_square(), (x[0] - x[2]).norm_square()});
  return longest > 0. ? area_vector(x).norm() / (0.25 * std::sqrt(3.) * longest) : 0.;
}

/// Cosine of the angle between the normal of a triangle and what is outwards on its patch.
inline double outwardness(const Corners3& x, unsigned patch, const SurfaceProjection& projection) {
  const auto normal = area_vector(x);
  const Point<3> centroid((x[0] + x[1] + x[2]) / 3.);
  return projection.outward(centroid, patch) * normal / std::max(normal.norm(), 1e-300);
}

/// Whether a triangle may take the shape `after`: it must not become a sliver,
/// turn by more than 60 degrees, or turn inwards; if it was as bad before, it must
/// not get worse. Slivers, as a contour has many, have no normal to keep.
inline bool may_become(const Corners3& before, const Corners3& after, unsigned patch,
                       const SurfaceProjection& projection) {
  constexpr double sliver = 0.05, least_outwardness = 0.2;
  const double fullness_before = fullness(before);
  if (fullness(after) < std::min(sliver, fullness_before))
    return false;
  const auto normal = area_vector(after), old_normal = area_vector(before);
  if (fullness_before >= sliver && old_normal * normal < 0.5 * old_normal.norm() * normal.norm())
    return false;
  const double outward = outwardness(after, patch, projection);
  return outward > least_outwardness || outward > outwardness(before, patch, projection);
}

} // namespace prosup::mesh

#endif
