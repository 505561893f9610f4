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

template <typename Real>
Real step(const Fields<Real>& fields, std::size_t begin, std::size_t end) {
  const FlushToZero flush_to_zero;
  // No std::array or lambda: nothing may be shared with other files.
  const Real* __restrict__ const u0 = fields.u[0];
  const Real* __restrict__ const u1 = fields.u[1];
  const Real* __restrict__ const u2 = fields.u[2];
  const Real* __restrict__ const mu_map = fields.mu;
  const Real* __restrict__ const lambda_map = fields.lambda;
  const Real* __restrict__ const mobility_map = fields.mobility;
  const std::ptrdiff_t y = fields.row, z = fields.plane;
  const Real first = Real(0.5) / fields.spacing;
  const Real second = Real(1) / (fields.spacing * fields.spacing);
  const Real mixed = Real(0.25) * second;
  const Real inverse_density = fields.inverse_density, squared_step = fields.squared_step;
  Real min_jacobian = Real(1e30);

#pragma GCC ivdep
  for (std::size_t n = begin; n < end; ++n) {
    // Derivatives: D[k][I] = u_k,I; S[k][.] = u_k,xx yy zz yz xz xy.
    Real D[3][3], S[3][6];
#define PROSUP_DERIVE(k, u)                                                                        \
  {                                                                                                \
    const Real* const at = u + n;                                                                  \
    const Real centre2 = Real(2) * at[0];                                                          \
    D[k][0] = (at[1] - at[-1]) * first;                                                            \
    D[k][1] = (at[y] - at[-y]) * first;                                                            \
    D[k][2] = (at[z] - at[-z]) * first;                                                            \
    S[k][0] = (at[1] + at[-1] - centre2) * second;                                                 \
    S[k][1] = (at[y] + at[-y] - centre2) * second;                                                 \
    S[k][2] = (at[z] + at[-z] - centre2) * second;                                                 \
    S[k][3] = (at[y + z] + at[-y - z] - at[y - z] - at[z - y]) * mixed;                            \
    S[k][4] = (at[1 + z] + at[-1 - z] - at[1 - z] - at[z - 1]) * mixed;                            \
    S[k][5] = (at[1 + y] + at[-1 - y] - at[1 - y] - at[y - 1]) * mixed;                            \
  }
    PROSUP_DERIVE(0, u0)
    PROSUP_DERIVE(1, u1)
    PROSUP_DERIVE(2, u2)
#undef PROSUP_DERIVE

    const Real F[3][3] = {{D[0][0] + 1, D[0][1], D[0][2]},
                          {D[1][0], D[1][1] + 1, D[1][2]},
                          {D[2][0], D[2][1], D[2][2] + 1}};
    // A[I][j] = J G_Ij with G = F^-1.
    const Real A[3][3] = {
        {F[1][1] * F[2][2] - F[1][2] * F[2][1], F[0][2] * F[2][1] - F[0][1] * F[2][2],
         F[0][1] * F[1][2] - F[0][2] * F[1][1]},
        {F[1][2] * F[2][0] - F[1][0] * F[2][2], F[0][0] * F[2][2] - F[0][2] * F[2][0],
         F[0][2] * F[1][0] - F[0][0] * F[1][2]},
        {F[1][0] * F[2][1] - F[1][1] * F[2][0], F[0][1] * F[2][0] - F[0][0] * F[2][1],
         F[0][0] * F[1][1] - F[0][1] * F[1][0]}};
    const Real J = F[0][0] * A[0][0] + F[0][1] * A[1][0] + F[0][2] * A[2][0];
    const Real inverse_J = Real(1) / J;
    // Where tissue is inverted the run is about to be undone: any number will do.
    const Real ln_J = natural_log(J > Real(1e-6) ? J : Real(1e-6));

    // d_I ln J = G_Lk u_k,LI
    const Real ln_J_0 = (A[0][0] * S[0][0] + A[0][1] * S[1][0] + A[0][2] * S[2][0] +
                         A[1][0] * S[0][5] + A[1][1] * S[1][5] + A[1][2] * S[2][5] +
                         A[2][0] * S[0][4] + A[2][1] * S[1][4] + A[2][2] * S[2][4]) *
                        inverse_J;
    const Real ln_J_1 = (A[0][0] * S[0][5] + A[0][1] * S[1][5] + A[0][2] * S[2][5] +
                         A[1][0] * S[0][1] + A[1][1] * S[1][1] + A[1][2] * S[2][1] +
                         A[2][0] * S[0][3] + A[2][1] * S[1][3] + A[2][2] * S[2][3]) *
                        inverse_J;
    const Real ln_J_2 = (A[0][0] * S[0][4] + A[0][1] * S[1][4] + A[0][2] * S[2][4] +
                         A[1][0] * S[0][3] + A[1][1] * S[1][3] + A[1][2] * S[2][3] +
                         A[2][0] * S[0][2] + A[2][1] * S[1][2] + A[2][2] * S[2][2]) *
                        inverse_J;

    // Gradients of the maps, and their means over three nodes along each axis: with
    // mu_I for the mu in (mu u_,I)_,I = mu u_,II + mu_,I u_,I the sum of both terms is
    //   (m+ (u+ - u) - m- (u - u-))/h^2,  m+- = (mu + mu+-)/2,
    // a symmetric operator. With mu itself it is not, and flutters where mu jumps.
    const Real mu = Real(2) * mu_map[n], lambda = Real(2) * lambda_map[n];
#define PROSUP_MAP(I, stride)                                                                      \
  const Real mu_##I = (mu_map[n + stride] - mu_map[n - stride]) * first;                           \
  const Real mean_mu_##I = (mu_map[n + stride] + mu_map[n - stride] + mu) * Real(0.25);            \
  const Real lambda_##I = (lambda_map[n + stride] - lambda_map[n - stride]) * first;               \
  const Real mean_lambda_##I =                                                                     \
      (lambda_map[n + stride] + lambda_map[n - stride] + lambda) * Real(0.25);
    PROSUP_MAP(0, 1)
    PROSUP_MAP(1, y)
    PROSUP_MAP(2, z)
#undef PROSUP_MAP

    // By Piola's identity d_I G_Ij = -G_Ij d_I ln J, so that
    //   d_I P_jI = mu u_j,II + F_jI d_I mu
    //            + G_Ij ((mu + lambda - lambda ln J) d_I ln J + ln J d_I lambda - d_I mu).
    const Real compliance = Real(1) - ln_J;
    const Real v0 =
        ((mean_mu_0 + mean_lambda_0 * compliance) * ln_J_0 + ln_J * lambda_0 - mu_0) * inverse_J;
    const Real v1 =
        ((mean_mu_1 + mean_lambda_1 * compliance) * ln_J_1 + ln_J * lambda_1 - mu_1) * inverse_J;
    const Real v2 =
        ((mean_mu_2 + mean_lambda_2 * compliance) * ln_J_2 + ln_J * lambda_2 - mu_2) * inverse_J;
    const Real mobility = mobility_map[n];
#define PROSUP_ADVANCE(j)                                                                          \
  {                                                                                                \
    const Real divergence = mean_mu_0 * S[j][0] + mean_mu_1 * S[j][1] + mean_mu_2 * S[j][2] +      \
                            F[j][0] * mu_0 + F[j][1] * mu_1 + F[j][2] * mu_2 + A[0][j] * v0 +      \
                            A[1][j] * v1 + A[2][j] * v2;                                           \
    Real* __restrict__ const increment = fields.increment[j];                                      \
    increment[n] = mobility * (increment[n] +                                                      \
                               squared_step * (divergence * inverse_density + fields.f[j][n]));    \
  }
    PROSUP_ADVANCE(0)
    PROSUP_ADVANCE(1)
    PROSUP_ADVANCE(2)
#undef PROSUP_ADVANCE
    const Real watched = mobility > Real(0) ? J : Real(1);
    min_jacobian = watched < min_jacobian ? watched : min_jacobian;
  }
  return min_jacobian;
}

} // namespace

const Kernels kernels{PROSUP_INSTRUCTION_SET_NAME, step<float>, step<double>};

} // namespace prosup::fdm::kernel::PROSUP_INSTRUCTION_SET

#undef PROSUP_INSTRUCTION_SET
#undef PROSUP_INSTRUCTION_SET_NAME
