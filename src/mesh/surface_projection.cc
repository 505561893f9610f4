#include "surface_projection.h"

#include <cmath>

namespace prosup::mesh {

Point<3> SurfaceProjection::operator()(const Point<3>& x, unsigned patches) const {
  Point<3> start = x;
  bool fixed[3] = {false, false, false};
  for (unsigned p = 0; p < TriangleMesh::free_surface; ++p)
    if (patches & set_of(p)) {
      fixed[p / 2] = true;
      start[p / 2] = phi_.box()[p % 2][p / 2];
    }
  if (!(patches & set_of(TriangleMesh::free_surface)))
    return start;
  Point<3> result = start;
  const double tolerance = 2e-3 * reach_;
  for (unsigned iteration = 0; iteration < 10; ++iteration) {
    dealii::Tensor<1, 3> gradient;
    const double distance = phi_.value_and_gradient(result, gradient) - level_;
    if (std::abs(distance) < tolerance)
      return result;
    for (unsigned d = 0; d < 3; ++d)
      if (fixed[d])
        gradient[d] = 0.;
    // Flatter than this, the level set is not near in the directions left.
    if (gradient.norm_square() < 0.04)
      break;
    result -= distance / gradient.norm_square() * gradient;
    if ((result - start).norm() > reach_)
      break;
  }
  return start;
}

} // namespace prosup::mesh
