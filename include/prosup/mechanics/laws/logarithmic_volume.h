#ifndef PROSUP_MECHANICS_LOGARITHMIC_VOLUME_H
#define PROSUP_MECHANICS_LOGARITHMIC_VOLUME_H

#include "prosup/mechanics/laws/coefficients.h"

namespace prosup::mechanics {

/// Volumetric part of an energy density, U = lambda/2 (ln J)^2, and its derivatives with respect
/// to ln J, Pa. The pressure dU/dJ is volume_slope / J.
struct LogarithmicVolume {
  template <typename T>
  PROSUP_LAW_INLINE T volume_energy(T lambda, T log_J) const {
    return 0.5 * lambda * log_J * log_J;
  }
  template <typename T>
  PROSUP_LAW_INLINE T volume_slope(T lambda, T log_J) const {
    return lambda * log_J;
  }
  template <typename T>
  PROSUP_LAW_INLINE T volume_curvature(T lambda, T) const {
    return lambda;
  }
};

} // namespace prosup::mechanics

#endif
