#ifndef PROSUP_MECHANICS_YEOH_H
#define PROSUP_MECHANICS_YEOH_H

#include "prosup/mechanics/laws/logarithmic_volume.h"

namespace prosup::mechanics {

/// Yeoh's polynomial (Rubber Chem. Technol. 66, 754, 1993) for compressible tissue that stiffens as
/// it is stretched:
///   W = mu/2 (k + c2 k^2 + c3 k^3) + lambda/2 (ln J)^2,  k = I1 - 3 - 2 ln J,
///   P = mu s (F - F^-T) + lambda ln J F^-T,  s = 1 + 2 c2 k + 3 c3 k^2.
/// Without a change of volume k is Yeoh's I1 - 3. The term in ln J makes k of second order in the
/// strain, so that mu and lambda are the moduli of small strains whatever c2 and c3 are. As k is
/// polyconvex and not negative, so is W for c2, c3 >= 0. c2 = c3 = 0 is the neo-Hookean law.
struct Yeoh : LogarithmicVolume {
  static constexpr const char* name = "yeoh";
  static constexpr const char* section = "Yeoh";

  double c2 = 1.;
  double c3 = 0.;

  template <typename Visit>
  void coefficients(const Visit& visit) {
    visit("Quadratic coefficient", c2, 0., 1e3,
          "c2 in W = mu/2 (k + c2 k^2 + c3 k^3) + lambda/2 (ln J)^2 with k = I1 - 3 - 2 ln J. "
          "Units: none. The default is an example and not measured.");
    visit("Cubic coefficient", c3, 0., 1e3,
          "c3 in W, see 'Quadratic coefficient'. Units: none. With 0 for both the law is "
          "neo-Hookean.");
  }

  template <typename T>
  PROSUP_LAW_INLINE T distortion_energy(T mu, T I1, T log_J) const {
    const T k = I1 - 3. - 2. * log_J;
    return 0.5 * mu * k * (1. + k * (uniform<T>(c2) + uniform<T>(c3) * k));
  }
  template <typename T>
  PROSUP_LAW_INLINE StressCoefficients<T> distortion_stress(T mu, T I1, T log_J) const {
    const T k = I1 - 3. - 2. * log_J;
    const T mu_s = mu * (1. + k * (uniform<T>(2. * c2) + uniform<T>(3. * c3) * k));
    return {mu_s, -mu_s};
  }
  template <typename T>
  PROSUP_LAW_INLINE TangentCoefficients<T> distortion_tangent(T mu, T I1, T log_J) const {
    const T k = I1 - 3. - 2. * log_J;
    const T slope = 2. * mu * (uniform<T>(2. * c2) + uniform<T>(6. * c3) * k); // 2 mu ds/dk
    return {slope, -slope, slope};
  }
};

} // namespace prosup::mechanics

#endif
