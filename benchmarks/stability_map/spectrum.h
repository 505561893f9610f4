#ifndef PROSUP_BENCHMARKS_STABILITY_MAP_SPECTRUM_H
#define PROSUP_BENCHMARKS_STABILITY_MAP_SPECTRUM_H

#include "breast.h"

namespace prosup::benchmarks {

/// What the linearisation about the settled state says (docs/unloading.md). With
/// the residual R(X, x) = internal - external force at the free nodes,
///   K = dR/dx at fixed X,  A = -dR/dX at fixed x,  M the lumped masses.
struct Spectrum {
  bool is_stable = false;         ///< K is positive: the loaded state is one that lasts
  double lowest_frequency = 0.;   ///< omega_1 of K phi = omega^2 M phi, 1/s
  double critical_step = 0.;      ///< of central differences, s
  double asymmetry = 0.;          ///< |A - A^T| / |A + A^T|, Frobenius
  double step_ratio = 0.;         ///< critical step with A over that with K
  double largest_angle = 0.;      ///< |arg lambda| of A phi = lambda M phi, degrees
  double critical_damping = 0.;   ///< max |Im lambda| / sqrt(Re lambda), 1/s
  double smallest_following = 0.; ///< smallest Re of the eigenvalues of K^-1 A
  double largest_jump = 0.;       ///< largest |1 - eigenvalue of K^-1 A|
};

/// The matrices by central differences of the forces, their eigenvalues by
/// LAPACK. For Newton's solution of `breast`.
Spectrum measure_spectrum(const HalfBall& breast);

} // namespace prosup::benchmarks

#endif
