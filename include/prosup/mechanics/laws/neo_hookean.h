#ifndef PROSUP_MECHANICS_NEO_HOOKEAN_H
#define PROSUP_MECHANICS_NEO_HOOKEAN_H

#include "prosup/mechanics/laws/logarithmic_volume.h"

namespace prosup::mechanics {

/// The compressible neo-Hookean law of the paper (eq. 2), see coefficients.h:
///   W = mu/2 (I1 - 3) - mu ln J + lambda/2 (ln J)^2,
///   P = mu F + (lambda ln J - mu) F^-T.
struct NeoHookean : LogarithmicVolume {
  static constexpr const char* name = "neo-hookean";
  static constexpr const char* section = "";

  template <typename Visit>
  void coefficients(const Visit&) {}

  template <typename T>
  PROSUP_LAW_INLINE T distortion_energy(T mu, T I1, T log_J) const {
    return mu * (0.5 * (I1 - 3.) - log_J);
  }
  template <typename T>
  PROSUP_LAW_INLINE StressCoefficients<T> distortion_stress(T mu, T, T) const {
    return {mu, -mu};
  }
  template <typename T>
  PROSUP_LAW_INLINE TangentCoefficients<T> distortion_tangent(T, T, T) const {
    return {T{}, T{}, T{}};
  }
};

} // namespace prosup::mechanics

#endif
