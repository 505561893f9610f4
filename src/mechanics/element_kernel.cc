#include "element_kernel.h"

#include <math.h>

// Several instruction sets in one binary, chosen when the program is loaded.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) &&                             \
    !defined(__SANITIZE_ADDRESS__)
#define PROSUP_MULTIVERSION                                                                        \
  __attribute__((target_clones("arch=skylake-avx512", "arch=haswell", "default")))
#else
#define PROSUP_MULTIVERSION
#endif

#define LANES(l) for (int l = 0; l < n_lanes; ++l)

namespace prosup::mechanics::kernel {

namespace {

constexpr double smallest_jacobian = 1e-3;

typedef double Lanes[n_lanes];
typedef Lanes Matrix[3][3];

// Edge vectors of a nodal field, as columns: E[c][b] = v_(b+1)[c] - v_0[c].
inline __attribute__((always_inline)) void gather_edges(const Batch& batch, const double* field,
                                                        Matrix edges) {
  LANES(l) {
    const double* v0 = field + 3 * static_cast<size_t>(batch.node[0][l]);
    for (int b = 0; b < 3; ++b) {
      const double* v = field + 3 * static_cast<size_t>(batch.node[b + 1][l]);
      for (int c = 0; c < 3; ++c)
        edges[c][b][l] = v[c] - v0[c];
    }
  }
}

// Cofactors: inverse transpose times the determinant.
inline __attribute__((always_inline)) void cofactors(const Matrix A, Matrix cof, Lanes det) {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      LANES(l) cof[i][j][l] = A[i1][j1][l] * A[i2][j2][l] - A[i1][j2][l] * A[i2][j1][l];
    }
  LANES(l)
  det[l] = A[0][0][l] * cof[0][0][l] + A[0][1][l] * cof[0][1][l] + A[0][2][l] * cof[0][2][l];
}

// Natural logarithm of positive lanes to 1e-15, without a call, so that the
// loop stays vectorised: x = m 2^e with m in [sqrt(1/2), sqrt(2)), and
// ln m = 2 artanh((m - 1)/(m + 1)) as a series.
inline __attribute__((always_inline)) void logarithm(const Lanes x, Lanes result) {
  constexpr std::uint64_t sqrt_half = 0x3fe6a09e667f3bcdu, one = 0x3ff0000000000000u;
  constexpr std::uint64_t mantissa = 0x000fffffffffffffu, two_52 = 0x4330000000000000u;
  LANES(l) {
    std::uint64_t bits, exponent_bits;
    __builtin_memcpy(&bits, &x[l], sizeof bits);
    bits += one - sqrt_half;
    exponent_bits = (bits >> 52) | two_52;
    bits = (bits & mantissa) + sqrt_half;
    double m, exponent;
    __builtin_memcpy(&m, &bits, sizeof m);
    __builtin_memcpy(&exponent, &exponent_bits, sizeof exponent);
    exponent -= 4503599627370496. + 1023.;
    const double s = (m - 1.) / (m + 1.), s2 = s * s;
    const double series =
        1. +
        s2 * (1. / 3 +
              s2 * (1. / 5 +
                    s2 * (1. / 7 +
                          s2 * (1. / 9 +
                                s2 * (1. / 11 +
                                      s2 * (1. / 13 +
                                            s2 * (1. / 15 + s2 * (1. / 17 + s2 * (1. / 19)))))))));
    result[l] = exponent * 0.6931471805599453 + 2. * s * series;
  }
}

inline __attribute__((always_inline)) void
deformation_gradient(const Batch& batch, const double* displacement, Matrix F) {
  Matrix edges;
  gather_edges(batch, displacement, edges);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      LANES(l)
  F[i][j][l] = (i == j ? 1. : 0.) + edges[i][0][l] * batch.inverse_edges[0][j][l] +
               edges[i][1][l] * batch.inverse_edges[1][j][l] +
               edges[i][2][l] * batch.inverse_edges[2][j][l];
}

} // namespace

PROSUP_MULTIVERSION
double set_reference(Batch* batches, size_t n_batches, size_t n_cells, const double* reference) {
  double smallest = HUGE_VAL;
  for (size_t i = 0; i < n_batches; ++i) {
    Batch& batch = batches[i];
    Matrix edges, cof;
    Lanes det;
    gather_edges(batch, reference, edges);
    cofactors(edges, cof, det);
    for (int b = 0; b < 3; ++b)
      for (int j = 0; j < 3; ++j)
        LANES(l) batch.inverse_edges[b][j][l] = cof[j][b][l] / det[l];
    LANES(l) {
      const bool real = i * n_lanes + l < n_cells;
      batch.volume[l] = real ? det[l] / 6. : 0.;
      if (real && batch.volume[l] < smallest)
        smallest = batch.volume[l];
    }
  }
  return smallest;
}

PROSUP_MULTIVERSION
double subtract_neo_hookean(const Batch* batches, size_t n_batches, const double* displacement,
                            double* force) {
  Lanes smallest;
  LANES(l) smallest[l] = HUGE_VAL;
  for (size_t i = 0; i < n_batches; ++i) {
    const Batch& batch = batches[i];
    Matrix F, cof;
    Lanes J, safe, log_J, pressure;
    deformation_gradient(batch, displacement, F);
    cofactors(F, cof, J);
    LANES(l) {
      smallest[l] = J[l] < smallest[l] ? J[l] : smallest[l];
      safe[l] = J[l] > smallest_jacobian ? J[l] : smallest_jacobian;
    }
    logarithm(safe, log_J);
    LANES(l) pressure[l] = (batch.lambda[l] * log_J[l] - batch.mu[l]) / safe[l];
    // f_a[c] = V P[c][j] dN_a/dX_j
    Lanes nodal[4][3];
    for (int c = 0; c < 3; ++c) {
      Lanes P[3];
      for (int j = 0; j < 3; ++j)
        LANES(l)
      P[j][l] = batch.volume[l] * (batch.mu[l] * F[c][j][l] + pressure[l] * cof[c][j][l]);
      for (int b = 0; b < 3; ++b)
        LANES(l)
      nodal[b + 1][c][l] = P[0][l] * batch.inverse_edges[b][0][l] +
                           P[1][l] * batch.inverse_edges[b][1][l] +
                           P[2][l] * batch.inverse_edges[b][2][l];
      LANES(l) nodal[0][c][l] = -(nodal[1][c][l] + nodal[2][c][l] + nodal[3][c][l]);
    }
    LANES(l)
    for (int a = 0; a < 4; ++a) {
      double* f = force + 3 * static_cast<size_t>(batch.node[a][l]);
      for (int c = 0; c < 3; ++c)
        f[c] -= nodal[a][c][l];
    }
  }
  double least = smallest[0];
  LANES(l) least = smallest[l] < least ? smallest[l] : least;
  return least;
}

size_t find_cell_below(const Batch* batches, size_t n_cells, const double* displacement,
                       double bound) {
  for (size_t i = 0; i * n_lanes < n_cells; ++i) {
    Matrix F, cof;
    Lanes J;
    deformation_gradient(batches[i], displacement, F);
    cofactors(F, cof, J);
    LANES(l)
    if (i * n_lanes + l < n_cells && !(J[l] > bound))
      return i * n_lanes + l;
  }
  return n_cells;
}

} // namespace prosup::mechanics::kernel
