#ifndef PROSUP_MECHANICS_ELEMENT_TANGENT_H
#define PROSUP_MECHANICS_ELEMENT_TANGENT_H

#include <vector>

#include "element_shape.h"
#include "point_response.h"

namespace prosup::mechanics {

/// One vector per node of an element.
using ElementVector = std::array<dealii::Tensor<1, 3>, 10>;

/// Derivatives of nodal forces with respect to nodal positions: one 3 x 3 block for each pair of
/// nodes, g/s^2, stored as a dense matrix of 3 n rows, row by row.
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
  /// Sets the rows and columns of a node to zero.
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

/// Kinematics at a quadrature point of an element.
struct PointKinematics {
  double volume = 0.;            ///< weight times det dX/dxi, mm^3
  double jacobian = 0.;          ///< J = det F
  dealii::Tensor<2, 3> F;        ///< dx/dX
  ElementVector gradient_X;      ///< G_a = dN_a/dX, 1/mm
  ElementVector gradient_x;      ///< g_a = dN_a/dx = F^-T G_a, 1/mm
  const double* shape = nullptr; ///< N_a
};

/// Kinematics at point q for nodes at X (unloaded) and x (loaded). The gradients are valid only if
/// `volume` and `jacobian` are positive.
PointKinematics point_kinematics(const ElementShape& shape, unsigned q, const ElementVector& X,
                                 const ElementVector& x);

/// Adds the nodal forces f_a = V P G_a, g mm/s^2, of the stress P = a F + (b + p J) F^-T. The
/// pressure p (Pa) is that of averaged nodal pressure, which does not depend on the element alone.
void add_internal_force(const PointKinematics& point, unsigned n_nodes,
                        const StressCoefficients<double>& stress, double pressure,
                        ElementVector& force);

/// Adds the derivative of these forces with respect to the loaded positions x at fixed X and p:
/// with h_a = F G_a,
///   k_ab = V [a G_a.G_b I - (b + p J) g_b g_a^T
///             + aa h_a h_b^T + ab (h_a g_b^T + g_a h_b^T) + (bb + p J) g_a g_b^T].
void add_tangent_by_loaded(const PointKinematics& point, const PointResponse& response,
                           double pressure, ElementMatrix& tangent);

/// Adds the derivative of these forces with respect to the unloaded positions X at fixed x and p.
/// In f_a = v sigma g_a the loaded volume v and g_a do not change, nor does the part of p:
///   k_ab = V [(a h_a + b g_a) G_b^T - a (G_a.G_b F + h_b G_a^T)
///             - h_a (aa F^T h_b + ab G_b)^T - g_a (ab F^T h_b + bb G_b)^T].
void add_tangent_by_unloaded(const PointKinematics& point, const PointResponse& response,
                             ElementMatrix& tangent);

/// Adds the derivative with respect to X of f_a = V N_a b, the nodal forces of the body force b
/// per unloaded volume: V N_a b G_b^T, times `factor`.
void add_body_force_by_unloaded(const PointKinematics& point,
                                const dealii::Tensor<1, 3>& body_force, double factor,
                                ElementMatrix& tangent);

} // namespace prosup::mechanics

#endif
