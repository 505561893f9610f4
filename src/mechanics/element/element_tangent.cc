#include "element_tangent.h"

#include <cmath>

namespace prosup::mechanics {

using namespace dealii;

namespace {

Tensor<2, 3> by_reference_coordinates(const ElementShape& shape, unsigned q,
                                      const ElementVector& nodes) {
  Tensor<2, 3> sum;
  for (unsigned a = 0; a < shape.n_nodes; ++a)
    sum += outer_product(nodes[a], shape.gradient[q][a]);
  return sum;
}

/// h_a = F G_a.
ElementVector stretched_gradients(const PointKinematics& point, unsigned n_nodes) {
  ElementVector h;
  for (unsigned a = 0; a < n_nodes; ++a)
    h[a] = point.F * point.gradient_X[a];
  return h;
}

} // namespace

PointKinematics point_kinematics(const ElementShape& shape, unsigned q, const ElementVector& X,
                                 const ElementVector& x) {
  PointKinematics point;
  point.shape = shape.value[q].data();
  const Tensor<2, 3> dX = by_reference_coordinates(shape, q, X);
  const Tensor<2, 3> dx = by_reference_coordinates(shape, q, x);
  const double det_X = determinant(dX), det_x = determinant(dx);
  point.volume = shape.weight * det_X;
  point.jacobian = det_X > 0. ? det_x / det_X : -std::abs(det_x);
  if (!(det_X > 0.) || !(det_x > 0.))
    return point;
  const Tensor<2, 3> dxi_dX = invert(dX), dxi_dx = invert(dx);
  point.F = dx * dxi_dX;
  for (unsigned a = 0; a < shape.n_nodes; ++a) {
    point.gradient_X[a] = shape.gradient[q][a] * dxi_dX;
    point.gradient_x[a] = shape.gradient[q][a] * dxi_dx;
  }
  return point;
}

void add_internal_force(const PointKinematics& point, unsigned n_nodes,
                        const StressCoefficients<double>& stress, double pressure,
                        ElementVector& force) {
  const double along_g = stress.b + pressure * point.jacobian;
  for (unsigned a = 0; a < n_nodes; ++a)
    force[a] +=
        point.volume * (stress.a * (point.F * point.gradient_X[a]) + along_g * point.gradient_x[a]);
}

void add_tangent_by_loaded(const PointKinematics& point, const PointResponse& response,
                           double pressure, ElementMatrix& tangent) {
  const auto& [aa, ab, bb] = response.tangent;
  const double pJ = pressure * point.jacobian;
  const double V = point.volume;
  const double straight = V * (bb + pJ), crossed = -V * (response.stress.b + pJ);
  const unsigned n = tangent.n_nodes;
  for (unsigned a = 0; a < n; ++a)
    for (unsigned b = 0; b < n; ++b) {
      const Tensor<1, 3>&ga = point.gradient_x[a], &gb = point.gradient_x[b];
      const double on_diagonal =
          V * response.stress.a * (point.gradient_X[a] * point.gradient_X[b]);
      for (unsigned i = 0; i < 3; ++i) {
        for (unsigned j = 0; j < 3; ++j)
          tangent(a, i, b, j) += straight * ga[i] * gb[j] + crossed * gb[i] * ga[j];
        tangent(a, i, b, i) += on_diagonal;
      }
    }
  if (aa == 0.)
    return;
  const ElementVector h = stretched_gradients(point, n);
  for (unsigned a = 0; a < n; ++a)
    for (unsigned b = 0; b < n; ++b) {
      const Tensor<1, 3>&ga = point.gradient_x[a], &gb = point.gradient_x[b];
      for (unsigned i = 0; i < 3; ++i)
        for (unsigned j = 0; j < 3; ++j)
          tangent(a, i, b, j) += V * (h[a][i] * (aa * h[b][j] + ab * gb[j]) + ab * ga[i] * h[b][j]);
    }
}

void add_tangent_by_unloaded(const PointKinematics& point, const PointResponse& response,
                             ElementMatrix& tangent) {
  const auto& [aa, ab, bb] = response.tangent;
  const double mu = response.stress.a;
  const double V = point.volume;
  const unsigned n = tangent.n_nodes;
  const ElementVector h = stretched_gradients(point, n);
  for (unsigned a = 0; a < n; ++a) {
    const Tensor<1, 3>& Ga = point.gradient_X[a];
    const Tensor<1, 3> stress =
        V * (mu * h[a] + (response.stress.b - bb) * point.gradient_x[a] - ab * h[a]);
    for (unsigned b = 0; b < n; ++b) {
      const Tensor<1, 3>& Gb = point.gradient_X[b];
      const double product = V * mu * (Ga * Gb);
      for (unsigned i = 0; i < 3; ++i)
        for (unsigned j = 0; j < 3; ++j)
          tangent(a, i, b, j) +=
              stress[i] * Gb[j] - product * point.F[i][j] - V * mu * h[b][i] * Ga[j];
    }
  }
  if (aa == 0.)
    return;
  for (unsigned b = 0; b < n; ++b) {
    const Tensor<1, 3> Fh = V * (transpose(point.F) * h[b]);
    for (unsigned a = 0; a < n; ++a)
      tangent.add(a, b, outer_product(aa * h[a] + ab * point.gradient_x[a], Fh), -1.);
  }
}

void add_body_force_by_unloaded(const PointKinematics& point, const Tensor<1, 3>& body_force,
                                double factor, ElementMatrix& tangent) {
  for (unsigned a = 0; a < tangent.n_nodes; ++a)
    for (unsigned b = 0; b < tangent.n_nodes; ++b)
      tangent.add(a, b, outer_product(body_force, point.gradient_X[b]),
                  factor * point.volume * point.shape[a]);
}

} // namespace prosup::mechanics
