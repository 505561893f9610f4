#ifndef PROSUP_MECHANICS_ELEMENT_SHAPE_H
#define PROSUP_MECHANICS_ELEMENT_SHAPE_H

#include <deal.II/base/tensor.h>

#include "prosup/mechanics/body/body.h"

namespace prosup::mechanics {

/// Shape functions at the quadrature points of an element on the reference
/// tetrahedron (xi_b = L_b, b = 1..3): one point for linear elements, the four
/// points of the degree 2 rule for quadratic ones.
struct ElementShape {
  unsigned n_nodes = 0, n_points = 0;
  double weight = 0.; ///< of each point; sums to the volume 1/6
  std::array<std::array<double, 10>, 4> value{};
  std::array<std::array<dealii::Tensor<1, 3>, 10>, 4> gradient{}; ///< d N_a / d xi

  /// sum_a v_a (x) dN_a/dxi at point q for nodal vectors; columns are derivatives with
  /// respect to xi. `nodes` are those of Body::element_nodes().
  dealii::Tensor<2, 3> derivative(unsigned q, const unsigned* nodes,
                                  const NodeVector& vector) const {
    dealii::Tensor<2, 3> sum;
    for (unsigned a = 0; a < n_nodes; ++a)
      sum += outer_product(node_value(vector, nodes[a]), gradient[q][a]);
    return sum;
  }
};

/// The shape functions of a type of element.
const ElementShape& element_shape(ElementType type);

} // namespace prosup::mechanics

#endif
