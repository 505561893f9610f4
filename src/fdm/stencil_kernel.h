#ifndef PROSUP_SRC_FDM_STENCIL_KERNEL_H
#define PROSUP_SRC_FDM_STENCIL_KERNEL_H

#include <cstddef>

// The hot loop. This header and what it declares see neither deal.II nor the
// standard library's templates: the kernels are compiled with -ffast-math and
// once for each instruction set, and neither may leak into inline functions
// shared with other files.

namespace prosup::fdm::kernel {

/// Nodal fields, x fastest: the neighbours of node n along x, y and z are n +- 1,
/// n +- row and n +- plane.
template <typename Real>
struct Fields {
  const Real* u[3];     ///< displacement, mm
  const Real* mu;       ///< Pa
  const Real* lambda;   ///< Pa
  const Real* f[3];     ///< body force per mass, mm/s^2
  const Real* mobility; ///< 1/(1 + h_t r/rho), 0 where a node is held
  Real* increment[3];   ///< U^{n+1} - U^n, mm; before the step U^n - U^{n-1}
  std::ptrdiff_t row;   ///< nodes
  std::ptrdiff_t plane; ///< nodes
  Real spacing;         ///< mm
  Real inverse_density; ///< mm^3/g
  Real squared_step;    ///< h_t^2, s^2
};

/// One step of the paper's eq. 6, written for increments,
///   U^{n+1} - U^n = (U^n - U^{n-1} + h_t^2 K)/(1 + h_t r/rho),
/// at the nodes from `begin` to before `end`, whose neighbours all have to be in memory.
/// K = div_0 N/rho + f with the derivatives of u by eq. 7. Returns the smallest
/// J = det F of the nodes that move.
template <typename Real>
using Step = Real (*)(const Fields<Real>& fields, std::size_t begin, std::size_t end);

struct Kernels {
  const char* instruction_set;
  Step<float> step_float;
  Step<double> step_double;

  Step<float> step(float) const { return step_float; }
  Step<double> step(double) const { return step_double; }
};

/// The `n` kernels that this processor can run, in the order of their speed.
const Kernels* const* all_kernels(int& n);

/// The fastest of them, which is the last.
const Kernels& best_kernels();

// One translation unit each.
namespace baseline {
extern const Kernels kernels;
}
namespace avx2 {
extern const Kernels kernels;
}
namespace avx512 {
extern const Kernels kernels;
}

} // namespace prosup::fdm::kernel

#endif
