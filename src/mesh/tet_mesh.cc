#include "prosup/mesh/tet_mesh.h"

#include <deal.II/base/tensor.h>

namespace prosup::mesh {

double tet_volume(const Point<3>& a, const Point<3>& b, const Point<3>& c, const Point<3>& d) {
  return (b - a) * dealii::cross_product_3d(c - a, d - a) / 6.;
}

} // namespace prosup::mesh
