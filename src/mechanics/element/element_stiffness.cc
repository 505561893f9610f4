#include "element_stiffness.h"

#include <algorithm>
#include <cmath>

namespace prosup::mechanics {

using namespace dealii;

namespace {

/// Sums `value(element, nodes, sums)` over all elements and ranks.
template <typename Add>
std::vector<double> sum_elements(const Body& body, Add add) {
  std::vector<double> sums(body.n_local_nodes(), 0.);
  for (unsigned e = 0; e < body.n_elements(); ++e)
    add(e, body.element_nodes(e), sums);
  return body.sum_over_ranks(sums);
}

/// Norms of the gradients of the shape functions in two configurations.
struct Gradients {
  std::array<double, 10> reference, present;
  double volume = 0.; ///< of the point, reference configuration, mm^3
  double J = 0.;
};

Gradients gradients(const ElementShape& shape, unsigned q, const unsigned* nodes,
                    const NodeVector& reference, const NodeVector& displacement) {
  const Tensor<2, 3> D = shape.derivative(q, nodes, reference);
  const Tensor<2, 3> E = D + shape.derivative(q, nodes, displacement);
  Gradients result;
  result.volume = shape.weight * std::abs(determinant(D));
  result.J = determinant(E) / determinant(D);
  const Tensor<2, 3> inverse_D = invert(D), inverse_E = invert(E);
  for (unsigned a = 0; a < shape.n_nodes; ++a) {
    result.reference[a] = (shape.gradient[q][a] * inverse_D).norm();
    result.present[a] = (shape.gradient[q][a] * inverse_E).norm();
  }
  return result;
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

// The tangent of P = mu F + (lambda ln J - mu) F^-T couples nodes by
//   k_ab = V [mu G_a.G_b I + lambda g_a g_b^T + (mu - lambda ln J) g_b g_a^T]
// with G = grad_X N and g = grad_x N. The row of node a is bounded by
// V [mu |G_a| sum_b |G_b| + (lambda + |mu - lambda ln J|) |g_a| sum_b |g_b|].
std::vector<double> element_stiffness_bound(const Body& body, const NodeVector& reference,
                                            const NodeVector& displacement,
                                            const std::vector<LameParameters>& material) {
  const ElementShape& shape = element_shape(body.element().type);
  return sum_elements(body, [&](unsigned e, const unsigned* nodes, std::vector<double>& sums) {
    const LameParameters& m = material[material.size() == 1 ? 0 : e];
    for (unsigned q = 0; q < shape.n_points; ++q) {
      const Gradients g = gradients(shape, q, nodes, reference, displacement);
      const double log_J = std::log(std::max(g.J, 1e-3));
      double sum_reference = 0., sum_present = 0.;
      for (unsigned a = 0; a < shape.n_nodes; ++a) {
        sum_reference += g.reference[a];
        sum_present += g.present[a];
      }
      for (unsigned a = 0; a < shape.n_nodes; ++a)
        sums[nodes[a]] += g.volume * (m.mu * g.reference[a] * sum_reference +
                                      (m.lambda + std::abs(m.mu - m.lambda * log_J)) *
                                          g.present[a] * sum_present);
    }
  });
}

} // namespace prosup::mechanics
