#ifndef PROSUP_MECHANICS_MEMBRANE_TRIANGLE_H
#define PROSUP_MECHANICS_MEMBRANE_TRIANGLE_H

#include <deal.II/base/tensor.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace prosup::mechanics {

/// A symmetric 2 x 2 matrix ((a, b), (b, c)).
struct PlaneMatrix {
  double a, b, c;

  double determinant() const { return a * c - b * b; }
  PlaneMatrix inverse() const {
    const double scale = 1. / determinant();
    return {scale * c, -scale * b, scale * a};
  }
  double operator()(unsigned k, unsigned l) const { return k + l == 0 ? a : k + l == 1 ? b : c; }
};

/// The state of a membrane triangle whose edges D_k = X_k - X_0 and d_k = x_k - x_0 (k = 1, 2) have
/// the metrics M_kl = D_k.D_l and m_kl = d_k.d_l.
struct MembraneStretch {
  /// Squares of the principal stretches, the eigenvalues of M^-1 m; first >= second.
  double first, second;

  MembraneStretch(const PlaneMatrix& M_inverse, double det_M, const PlaneMatrix& m) {
    const double half_trace =
        0.5 * (M_inverse.a * m.a + 2. * M_inverse.b * m.b + M_inverse.c * m.c);
    const double determinant = m.determinant() / det_M;
    first = half_trace + std::sqrt(std::max(half_trace * half_trace - determinant, 0.));
    second = determinant / first;
  }
  /// Stretched in all directions. At rest it counts as taut, whatever the rounding.
  bool is_taut() const { return second * second * first > 1. - 1e-9; }
  /// Else, whether it is stretched in one direction, across which it wrinkles.
  bool is_stretched() const { return first > 1.; }
};

/// A triangle of an incompressible neo-Hookean membrane that carries no pressure, since a skin
/// wrinkles instead (the relaxed energy of Pipkin 1986), with corners at X unloaded and x loaded.
/// With the shear modulus times the thickness s (Pa mm), A = sqrt(det M)/2 and the squares
/// a >= b of the principal stretches its energy is
///   taut, b sqrt(a) > 1:  A s/2 (a + b + 1/(a b) - 3),  a + b = tr(M^-1 m), a b = det m/det M,
///   wrinkled, a > 1:      A s/2 (a + 2/sqrt(a) - 3),
///   slack:                0.
class MembraneTriangle {
public:
  using Corners = std::array<dealii::Tensor<1, 3>, 3>;
  using Blocks = std::array<dealii::Tensor<2, 3>, 9>; ///< 3 i + j for corners i and j

  MembraneTriangle(const Corners& X, const Corners& x, double stiffness);

  /// f_i = dE/dx_i, g mm/s^2: f_k = sum_l d_l T_kl, f_0 = -f_1 - f_2, with
  ///   taut: T = A s (M^-1 - m^-1/(a b)),   wrinkled: T = A s (1 - a^-3/2) v v^T,
  /// where v and w are the eigenvectors of M^-1 m for a and b, of length 1 in M.
  Corners forces() const;
  /// df_i/dx_j. Taut: with the duals p_k = sum_l m^-1_kl d_l, P = sum_l d_l p_l^T, c = A s/(a b),
  ///   T_kn I + c (2 p_k p_n^T + p_n p_k^T + m^-1_kn P);
  /// wrinkled: with V = sum_k v_k d_k, U = sum_k w_k d_k, B_k = v_k U + w_k V,
  ///   T_kn I + A s (3 a^-5/2 v_k v_n V V^T + (1 - a^-3/2)/(a - b) B_k B_n^T).
  Blocks by_loaded() const;
  /// df_i/dX_j. Taut: with the duals P0_k of D, F = sum_l d_l P0_l^T, h_n = sum_l M^-1_nl d_l,
  ///   (f_k - 2 c p_k) P0_n^T - A s (M^-1_kn F + h_n P0_k^T);
  /// wrinkled: with V0, U0 and B0_k made of D as V, U and B_k of d,
  ///   f_k P0_n^T - A s ((2 + a^-3/2) v_k v_n V V0^T + (1 - a^-3/2) a/(a - b) B_k B0_n^T).
  Blocks by_unloaded() const;

private:
  using Edges = std::array<dealii::Tensor<1, 3>, 2>;

  bool is_slack() const { return !stretch_.is_taut() && !stretch_.is_stretched(); }
  PlaneMatrix stress() const;

  const Edges D_, d_;
  const PlaneMatrix M_inverse_, m_inverse_;
  const double area_stiffness_; // A s
  const MembraneStretch stretch_;
  std::array<double, 2> v_{}, w_{}; // where it wrinkles
};

} // namespace prosup::mechanics

#endif
