#ifndef PROSUP_MECHANICS_ELEMENT_TANGENT_H
#define PROSUP_MECHANICS_ELEMENT_TANGENT_H

#include <vector>

#include "element_shape.h"
#include "prosup/mechanics/laws/material.h"

namespace prosup::mechanics {

/// One vector per node of an element.
using ElementVector = std::array<dealii::Tensor<1, 3>, 10>;

/// Derivatives of nodal forces by nodal positions: one 3 x 3 block per pair of
/// nodes, g/s^2, stored row by row as the dense matrix of 3 n rows.
struct ElementMatrix {
  unsigned n_nodes = 0;
  std::vector<double> values;

  void reset(unsigned n) {
    n_nodes = n;
    values.assign(static_cast<std::size_t>(9) * n * n, 0.);
  }
  double& operator()(unsigned a, unsigned i, unsigned b, unsigned j) {
    return values[static_cast<std::size_t>(3 * a + i) * 3 * n_nodes + 3 * b + j];
  }
  /// Zeros the rows and columns of a node.
  void clear(unsigned a) {
    for (unsigned i = 0; i < 3; ++i)
      for (unsigned b = 0; b < n_nodes; ++b)
        for (unsigned j = 0; j < 3; ++j)
          (*this)(a, i, b, j) = (*this)(b, j, a, i) = 0.;
  }
  void add(unsigned a, unsigned b, const dealii::Tensor<2, 3>& block, double factor = 1.) {
    for (unsigned i = 0; i < 3; ++i)
      for (unsigned j = 0; j < 3; ++j)
        (*this)(a, i, b, j) += factor * block[i][j];
  }
};

/// What an element knows at a quadrature point.
struct PointKinematics {
  double volume = 0.;            ///< weight times det dX/dxi, mm^3
  double jacobian = 0.;          ///< J = det F
  dealii::Tensor<2, 3> F;        ///< dx/dX
  ElementVector gradient_X;      ///< G_a = dN_a/dX, 1/mm
  ElementVector gradient_x;      ///< g_a = dN_a/dx = F^-T G_a, 1/mm
  const double* shape = nullptr; ///< N_a
};

/// Kinematics at point q for nodes at X (unloaded) and x (loaded). Gradients
/// mean nothing unless `volume` and `jacobian` are positive.
PointKinematics point_kinematics(const ElementShape& shape, unsigned q, const ElementVector& X,
                                 const ElementVector& x);

/// Stress law at a quadrature point: neo-Hookean, and a pressure p (Pa) that
/// does not depend on the element alone,
///   P = mu F + (lambda ln J - mu) F^-T + p J F^-T.
struct PointMaterial {
  double mu = 0., lambda = 0., pressure = 0.;
};

/// Adds f_a = V P G_a, g mm/s^2.
void add_internal_force(const PointKinematics& point, unsigned n_nodes,
                        const PointMaterial& material, ElementVector& force);

/// Adds the derivative of these forces by the loaded positions x at fixed X
/// (and fixed p), symmetric but for p:
///   k_ab = V [mu G_a.G_b I + (lambda + p J) g_a g_b^T + (mu - lambda ln J - p J) g_b g_a^T].
void add_tangent_by_loaded(const PointKinematics& point, const PointMaterial& material,
                           ElementMatrix& tangent);

/// Adds their derivative by the unloaded positions X at fixed x (and fixed p):
/// with f_a = v sigma g_a, where the loaded volume v and g_a do not change,
///   k_ab = V [(mu F G_a + (lambda ln J - mu - lambda) g_a) G_b^T
///             - mu (G_a.G_b F + F G_b G_a^T)].
void add_tangent_by_unloaded(const PointKinematics& point, const PointMaterial& material,
                             ElementMatrix& tangent);

/// Adds the derivative by X of f_a = V N_a b, the nodal forces of the body
/// force b per unloaded volume: V N_a b G_b^T, times `factor`.
void add_body_force_by_unloaded(const PointKinematics& point,
                                const dealii::Tensor<1, 3>& body_force, double factor,
                                ElementMatrix& tangent);

} // namespace prosup::mechanics

#endif
