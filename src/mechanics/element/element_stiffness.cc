#include "element_stiffness.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "element_tangent.h"

namespace prosup::mechanics {

using namespace dealii;

namespace {

/// Sums `value(element, nodes, sums)` over all elements and ranks.
template <typename Add>
std::vector<double> sum_elements(const Body& body, Add add) {
  std::vector<double> sums(body.n_local_nodes(), 0.);
  for (unsigned e = 0; e < body.n_elements(); ++e)
    add(e, body.element_nodes(e), sums);
  return sum_over_ranks(body, sums);
}

/// The kinematics of a quadrature point that its tangent depends on.
struct PointGradients {
  ElementVector reference, present; ///< G_a = dN_a/dX and g_a = dN_a/dx, 1/mm
  Tensor<2, 3> F;
  double volume = 0.; ///< of the point, reference configuration, mm^3
  double J = 0.;
};

PointGradients gradients(const ElementShape& shape, unsigned q, const unsigned* nodes,
                         const NodeVector& reference, const NodeVector& displacement) {
  const Tensor<2, 3> D = shape.derivative(q, nodes, reference);
  const Tensor<2, 3> E = D + shape.derivative(q, nodes, displacement);
  PointGradients result;
  result.volume = shape.weight * std::abs(determinant(D));
  result.J = determinant(E) / determinant(D);
  const Tensor<2, 3> inverse_D = invert(D), inverse_E = invert(E);
  result.F = E * inverse_D;
  for (unsigned a = 0; a < shape.n_nodes; ++a) {
    result.reference[a] = shape.gradient[q][a] * inverse_D;
    result.present[a] = shape.gradient[q][a] * inverse_E;
  }
  return result;
}

/// Adds factor |v_a| sum_b |v_b| to the bounds of the nodes a: what a term v_a v_b^T of the
/// tangent, times `factor`, adds to the norms of its rows.
template <typename VectorOf>
void add_row_norms(const VectorOf& v, unsigned n_nodes, double factor,
                   std::array<double, 10>& bound) {
  std::array<double, 10> norm;
  double sum = 0.;
  for (unsigned a = 0; a < n_nodes; ++a)
    sum += norm[a] = v(a).norm();
  for (unsigned a = 0; a < n_nodes; ++a)
    bound[a] += factor * norm[a] * sum;
}

/// Bounds on the norms of the rows of the tangent of element_tangent.h,
///   k_ab = V [a G_a.G_b I + aa m_a m_b^T + (bb - ab^2/aa) g_a g_b^T - b g_b g_a^T],
/// with m_a = F G_a + (ab/aa) g_a.
std::array<double, 10> row_bounds(const PointGradients& point, const PointResponse& response,
                                  unsigned n_nodes) {
  const auto& [aa, ab, bb] = response.tangent;
  const double ratio = aa == 0. ? 0. : ab / aa;
  std::array<double, 10> bound{};
  add_row_norms([&](unsigned a) { return point.reference[a]; }, n_nodes,
                point.volume * std::abs(response.stress.a), bound);
  add_row_norms([&](unsigned a) { return point.present[a]; }, n_nodes,
                point.volume * (std::abs(bb - ratio * ab) + std::abs(response.stress.b)), bound);
  if (aa != 0.)
    add_row_norms(
        [&](unsigned a) { return point.F * point.reference[a] + ratio * point.present[a]; },
        n_nodes, point.volume * std::abs(aa), bound);
  return bound;
}

constexpr double hrz_corner = 1. / 36., hrz_edge = 4. / 27.;

} // namespace

double point_jacobian(const ElementShape& shape, unsigned q, const unsigned* nodes,
                      const NodeVector& reference, const NodeVector& displacement) {
  const Tensor<2, 3> D = shape.derivative(q, nodes, reference);
  return determinant(D + shape.derivative(q, nodes, displacement)) / determinant(D);
}

std::vector<double> element_nodal_volume(const Body& body, const NodeVector& reference) {
  const ElementShape& shape = element_shape(body.element().type);
  return sum_elements(body, [&](unsigned, const unsigned* nodes, std::vector<double>& sums) {
    for (unsigned q = 0; q < shape.n_points; ++q) {
      const double volume = shape.weight * determinant(shape.derivative(q, nodes, reference));
      for (unsigned a = 0; a < shape.n_nodes; ++a)
        sums[nodes[a]] += shape.value[q][a] * volume;
    }
  });
}

std::vector<double> element_lumped_volume(const Body& body, const NodeVector& reference) {
  const ElementShape& shape = element_shape(body.element().type);
  return sum_elements(body, [&](unsigned, const unsigned* nodes, std::vector<double>& sums) {
    double volume = 0.;
    for (unsigned q = 0; q < shape.n_points; ++q)
      volume += shape.weight * determinant(shape.derivative(q, nodes, reference));
    for (unsigned a = 0; a < shape.n_nodes; ++a)
      sums[nodes[a]] += volume * (shape.n_nodes == 4 ? 0.25 : a < 4 ? hrz_corner : hrz_edge);
  });
}

std::vector<double> element_stiffness_bound(const Body& body, const NodeVector& reference,
                                            const NodeVector& displacement,
                                            const Material& material) {
  const ElementShape& shape = element_shape(body.element().type);
  const auto bound_of = [&](const auto& law) {
    return sum_elements(body, [&](unsigned e, const unsigned* nodes, std::vector<double>& sums) {
      for (unsigned q = 0; q < shape.n_points; ++q) {
        const PointGradients point = gradients(shape, q, nodes, reference, displacement);
        const auto bound = row_bounds(
            point, response(law, material[e], point.F, std::max(point.J, 1e-3)), shape.n_nodes);
        for (unsigned a = 0; a < shape.n_nodes; ++a)
          sums[nodes[a]] += bound[a];
      }
    });
  };
  return std::visit(bound_of, material.law());
}

} // namespace prosup::mechanics
