// The loop of stencil_kernel.h, included once for each instruction set by
// stencil_kernel_*.cc, which define PROSUP_INSTRUCTION_SET, the name of a
// namespace, and PROSUP_INSTRUCTION_SET_NAME. No include guard.

#include <math.h>

#include "stencil_kernel.h"

#ifdef __SSE__
#include <xmmintrin.h>
#endif

namespace prosup::fdm::kernel::PROSUP_INSTRUCTION_SET {

namespace {

/// Displacements fade away from the tissue to numbers so small that the processor
/// treats them in software, a hundred times as slowly: they count as zero here.
class FlushToZero {
public:
#ifdef __SSE__
  FlushToZero() : before_(_mm_getcsr()) {
    _mm_setcsr(before_ | 0x8040u);
  }
  ~FlushToZero() {
    _mm_setcsr(before_);
  }

private:
  unsigned before_;
#else
  FlushToZero() {}
#endif
};

// ln x = e ln 2 + 2 artanh t with x = 2^e m, t = (m - 1)/(m + 1), |t| < 0.172, to the
// last digits. Inlined, it spares the registers that a call would have to save.
inline float natural_log(float x) {
  int bits;
  __builtin_memcpy(&bits, &x, sizeof(bits));
  const int e = (bits - 0x3f3504f3) >> 23; // sqrt(1/2) <= m < sqrt(2)
  bits -= e * (1 << 23);
  float m;
  __builtin_memcpy(&m, &bits, sizeof(m));
  const float t = (m - 1.f) / (m + 1.f), s = t * t;
  return float(e) * 0.69314718f +
         t * (2.f + s * (2.f / 3.f + s * (2.f / 5.f + s * (2.f / 7.f + s * (2.f / 9.f)))));
}

inline double natural_log(double x) {
  return log(x);
}

// The functions below see one node each. They are inlined, so that the loop in step() is
// vectorised over nodes. No std::array or lambda: nothing may be shared with other files.
#define PROSUP_INLINE inline __attribute__((always_inline))

/// Derivatives of u by eq. 7 at a node: first[k][I] = u_k,I, and second[k] = u_k,xx yy zz
/// yz xz xy.
template <typename Real>
struct Derivatives {
  Real first[3][3], second[3][6];
};

/// Factors of the differences: 1/(2 h), 1/h^2 and 1/(4 h^2).
template <typename Real>
struct Factors {
  Real first, second, mixed;
};

template <typename Real>
PROSUP_INLINE void derive(const Real* at, std::ptrdiff_t y, std::ptrdiff_t z,
                          const Factors<Real>& factors, Real (&D)[3], Real (&S)[6]) {
  const Real centre2 = Real(2) * at[0];
  D[0] = (at[1] - at[-1]) * factors.first;
  D[1] = (at[y] - at[-y]) * factors.first;
  D[2] = (at[z] - at[-z]) * factors.first;
  S[0] = (at[1] + at[-1] - centre2) * factors.second;
  S[1] = (at[y] + at[-y] - centre2) * factors.second;
  S[2] = (at[z] + at[-z] - centre2) * factors.second;
  S[3] = (at[y + z] + at[-y - z] - at[y - z] - at[z - y]) * factors.mixed;
  S[4] = (at[1 + z] + at[-1 - z] - at[1 - z] - at[z - 1]) * factors.mixed;
  S[5] = (at[1 + y] + at[-1 - y] - at[1 - y] - at[y - 1]) * factors.mixed;
}

/// A[I][j] = J G_Ij with G = F^-1.
template <typename Real>
PROSUP_INLINE void cofactors(const Real (&F)[3][3], Real (&A)[3][3]) {
  A[0][0] = F[1][1] * F[2][2] - F[1][2] * F[2][1];
  A[0][1] = F[0][2] * F[2][1] - F[0][1] * F[2][2];
  A[0][2] = F[0][1] * F[1][2] - F[0][2] * F[1][1];
  A[1][0] = F[1][2] * F[2][0] - F[1][0] * F[2][2];
  A[1][1] = F[0][0] * F[2][2] - F[0][2] * F[2][0];
  A[1][2] = F[0][2] * F[1][0] - F[0][0] * F[1][2];
  A[2][0] = F[1][0] * F[2][1] - F[1][1] * F[2][0];
  A[2][1] = F[0][1] * F[2][0] - F[0][0] * F[2][1];
  A[2][2] = F[0][0] * F[1][1] - F[0][1] * F[1][0];
}

/// J d_I ln J = A_Lk u_k,LI, where `x`, `y` and `z` are the places of LI in the second
/// derivatives.
template <typename Real>
PROSUP_INLINE Real derivative_of_J(const Real (&A)[3][3], const Real (&S)[3][6], int x, int y,
                                   int z) {
  return A[0][0] * S[0][x] + A[0][1] * S[1][x] + A[0][2] * S[2][x] + A[1][0] * S[0][y] +
         A[1][1] * S[1][y] + A[1][2] * S[2][y] + A[2][0] * S[0][z] + A[2][1] * S[1][z] +
         A[2][2] * S[2][z];
}

/// A map near a node: its gradient, and its means over three nodes along each axis. With
/// mu_I for the mu in (mu u_,I)_,I = mu u_,II + mu_,I u_,I the sum of both terms is
///   (m+ (u+ - u) - m- (u - u-))/h^2,  m+- = (mu + mu+-)/2,
/// a symmetric operator. With mu itself it is not, and flutters where mu jumps.
template <typename Real>
struct Map {
  Real gradient[3], mean[3];
};

template <typename Real>
PROSUP_INLINE void sample(const Real* at, std::ptrdiff_t y, std::ptrdiff_t z,
                          const Factors<Real>& factors, Map<Real>& map) {
  const Real centre2 = Real(2) * at[0];
  map.gradient[0] = (at[1] - at[-1]) * factors.first;
  map.gradient[1] = (at[y] - at[-y]) * factors.first;
  map.gradient[2] = (at[z] - at[-z]) * factors.first;
  map.mean[0] = (at[1] + at[-1] + centre2) * Real(0.25);
  map.mean[1] = (at[y] + at[-y] + centre2) * Real(0.25);
  map.mean[2] = (at[z] + at[-z] + centre2) * Real(0.25);
}

/// Finds the divergence of the stress, and returns J. By Piola's identity
/// d_I G_Ij = -G_Ij d_I ln J, so that
///   d_I P_jI = mu u_j,II + F_jI d_I mu
///            + G_Ij ((mu + lambda - lambda ln J) d_I ln J + ln J d_I lambda - d_I mu).
template <typename Real>
PROSUP_INLINE Real divergence(const Derivatives<Real>& u, const Map<Real>& mu,
                              const Map<Real>& lambda, Real (&result)[3]) {
  const auto& D = u.first;
  const auto& S = u.second;
  const Real F[3][3] = {{D[0][0] + 1, D[0][1], D[0][2]},
                        {D[1][0], D[1][1] + 1, D[1][2]},
                        {D[2][0], D[2][1], D[2][2] + 1}};
  Real A[3][3];
  cofactors(F, A);
  const Real J = F[0][0] * A[0][0] + F[0][1] * A[1][0] + F[0][2] * A[2][0];
  const Real inverse_J = Real(1) / J;
  // A run that inverts tissue is about to be undone: any number will do.
  const Real ln_J = natural_log(J > Real(1e-6) ? J : Real(1e-6));
  const Real ln_J_0 = derivative_of_J(A, S, 0, 5, 4) * inverse_J;
  const Real ln_J_1 = derivative_of_J(A, S, 5, 1, 3) * inverse_J;
  const Real ln_J_2 = derivative_of_J(A, S, 4, 3, 2) * inverse_J;
  const Real compliance = Real(1) - ln_J;
  const Real v0 = ((mu.mean[0] + lambda.mean[0] * compliance) * ln_J_0 + ln_J * lambda.gradient[0] -
                   mu.gradient[0]) *
                  inverse_J;
  const Real v1 = ((mu.mean[1] + lambda.mean[1] * compliance) * ln_J_1 + ln_J * lambda.gradient[1] -
                   mu.gradient[1]) *
                  inverse_J;
  const Real v2 = ((mu.mean[2] + lambda.mean[2] * compliance) * ln_J_2 + ln_J * lambda.gradient[2] -
                   mu.gradient[2]) *
                  inverse_J;
  for (int j = 0; j < 3; ++j)
    result[j] = mu.mean[0] * S[j][0] + mu.mean[1] * S[j][1] + mu.mean[2] * S[j][2] +
                F[j][0] * mu.gradient[0] + F[j][1] * mu.gradient[1] + F[j][2] * mu.gradient[2] +
                A[0][j] * v0 + A[1][j] * v1 + A[2][j] * v2;
  return J;
}

template <typename Real>
Real step(const Fields<Real>& fields, std::size_t begin, std::size_t end) {
  const FlushToZero flush_to_zero;
  const Real* __restrict__ const u0 = fields.u[0];
  const Real* __restrict__ const u1 = fields.u[1];
  const Real* __restrict__ const u2 = fields.u[2];
  const Real* __restrict__ const mu_map = fields.mu;
  const Real* __restrict__ const lambda_map = fields.lambda;
  const Real* __restrict__ const mobility_map = fields.mobility;
  const Real* __restrict__ const f0 = fields.f[0];
  const Real* __restrict__ const f1 = fields.f[1];
  const Real* __restrict__ const f2 = fields.f[2];
  Real* __restrict__ const increment0 = fields.increment[0];
  Real* __restrict__ const increment1 = fields.increment[1];
  Real* __restrict__ const increment2 = fields.increment[2];
  const std::ptrdiff_t y = fields.row, z = fields.plane;
  const Real second = Real(1) / (fields.spacing * fields.spacing);
  const Factors<Real> factors{Real(0.5) / fields.spacing, second, Real(0.25) * second};
  const Real inverse_density = fields.inverse_density, squared_step = fields.squared_step;
  Real min_jacobian = Real(1e30);

#pragma GCC ivdep
  for (std::size_t n = begin; n < end; ++n) {
    Derivatives<Real> u;
    derive(u0 + n, y, z, factors, u.first[0], u.second[0]);
    derive(u1 + n, y, z, factors, u.first[1], u.second[1]);
    derive(u2 + n, y, z, factors, u.first[2], u.second[2]);
    Map<Real> mu, lambda;
    sample(mu_map + n, y, z, factors, mu);
    sample(lambda_map + n, y, z, factors, lambda);
    Real stress[3];
    const Real J = divergence(u, mu, lambda, stress);
    const Real mobility = mobility_map[n];
    increment0[n] =
        mobility * (increment0[n] + squared_step * (stress[0] * inverse_density + f0[n]));
    increment1[n] =
        mobility * (increment1[n] + squared_step * (stress[1] * inverse_density + f1[n]));
    increment2[n] =
        mobility * (increment2[n] + squared_step * (stress[2] * inverse_density + f2[n]));
    const Real watched = mobility > Real(0) ? J : Real(1);
    min_jacobian = watched < min_jacobian ? watched : min_jacobian;
  }
  return min_jacobian;
}

#undef PROSUP_INLINE

} // namespace

const Kernels kernels{PROSUP_INSTRUCTION_SET_NAME, step<float>, step<double>};

} // namespace prosup::fdm::kernel::PROSUP_INSTRUCTION_SET

#undef PROSUP_INSTRUCTION_SET
#undef PROSUP_INSTRUCTION_SET_NAME
