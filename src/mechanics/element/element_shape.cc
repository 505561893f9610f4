#include "element_shape.h"

#include <cmath>

#include "prosup/core/tet_topology.h"

namespace prosup::mechanics {

using namespace dealii;

namespace {

using Barycentric = std::array<double, 4>;

Tensor<1, 3> gradient_of(unsigned corner) {
  Tensor<1, 3> gradient;
  if (corner > 0)
    gradient[corner - 1] = 1.;
  else
    gradient = Tensor<1, 3>({-1., -1., -1.});
  return gradient;
}

ElementShape linear_shape() {
  ElementShape shape;
  shape.n_nodes = 4;
  shape.n_points = 1;
  shape.weight = 1. / 6.;
  for (unsigned a = 0; a < 4; ++a) {
    shape.value[0][a] = 0.25;
    shape.gradient[0][a] = gradient_of(a);
  }
  return shape;
}

ElementShape quadratic_shape() {
  ElementShape shape;
  shape.n_nodes = 10;
  shape.n_points = 4;
  shape.weight = 1. / 24.;
  for (unsigned q = 0; q < 4; ++q) {
    Barycentric L;
    L.fill((5. - std::sqrt(5.)) / 20.);
    L[q] = (5. + 3. * std::sqrt(5.)) / 20.;
    for (unsigned a = 0; a < 4; ++a) {
      shape.value[q][a] = L[a] * (2. * L[a] - 1.);
      shape.gradient[q][a] = (4. * L[a] - 1.) * gradient_of(a);
    }
    for (unsigned e = 0; e < 6; ++e) {
      const auto [i, j] = tet_edges[e];
      shape.value[q][4 + e] = 4. * L[i] * L[j];
      shape.gradient[q][4 + e] = 4. * (L[i] * gradient_of(j) + L[j] * gradient_of(i));
    }
  }
  return shape;
}

} // namespace

const ElementShape& element_shape(ElementType type) {
  static const ElementShape linear = linear_shape(), quadratic = quadratic_shape();
  return type == ElementType::quadratic ? quadratic : linear;
}

} // namespace prosup::mechanics
