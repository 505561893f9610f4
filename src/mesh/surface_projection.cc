#include "surface_projection.h"

#include <cmath>

namespace prosup::mesh {

bool SurfaceProjection::inside_box(const Point<3>& x) const {
  for (unsigned d = 0; d < 3; ++d)
    if (x[d] < phi_.box()[0][d] || x[d] > phi_.box()[1][d])
      return false;
  return true;
}

bool SurfaceProjection::apply(Point<3>& x, unsigned patches) const {
  bool fixed[3] = {false, false, false};
  for (unsigned p = 0; p < TriangleMesh::free_surface; ++p)
    if (patches & set_of(p)) {
      fixed[p / 2] = true;
      x[p / 2] = phi_.box()[p % 2][p / 2];
    }
  if (!(patches & set_of(TriangleMesh::free_surface)))
    return true;
  Point<3> near = x;
  const double tolerance = 2e-3 * reach_;
  for (unsigned iteration = 0; iteration < 10; ++iteration) {
    dealii::Tensor<1, 3> gradient;
    const double distance = phi_.value_and_gradient(near, gradient) - level_;
    if (std::abs(distance) < tolerance) {
      if (!inside_box(near))
        return false;
      x = near;
      return true;
    }
    for (unsigned d = 0; d < 3; ++d)
      if (fixed[d])
        gradient[d] = 0.;
    // Flatter than this, the level set is not near in the directions left.
    if (gradient.norm_square() < 0.04)
      return false;
    near -= distance / gradient.norm_square() * gradient;
    if ((near - x).norm() > reach_)
      return false;
  }
  return false;
}

dealii::Tensor<1, 3> SurfaceProjection::outward(const Point<3>& x, unsigned patch) const {
  dealii::Tensor<1, 3> normal;
  if (patch != TriangleMesh::free_surface) {
    normal[patch / 2] = patch % 2 == 0 ? -1. : 1.;
    return normal;
  }
  phi_.value_and_gradient(x, normal);
  const double norm = normal.norm();
  return norm > 0. ? normal / norm : normal;
}

} // namespace prosup::mesh
