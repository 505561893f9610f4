#ifndef SATURATING_H
#define SATURATING_H

#include <prosup/mechanics/laws/logarithmic_volume.h>

namespace prosup::mechanics {

/// A law of the user's own: tissue that is soft at first and r times as stiff once it is stretched,
///   W = mu/2 (k + (r - 1) k^2/(m + k)) + lambda/2 (ln J)^2,  k = I1 - 3 - 2 ln J,
/// with s = 1 + (r - 1) k (k + 2 m)/(m + k)^2 as in yeoh.h. Like k, which is polyconvex and not
/// negative, it is polyconvex for r >= 1, and mu and lambda are the moduli of small strains. It is
/// called OwnLaw so that prosup finds it.
struct OwnLaw : LogarithmicVolume {
  static constexpr const char* name = "saturating";
  static constexpr const char* section = "Saturating";

  double r = 3.;
  double m = 0.5;

  template <typename Visit>
  void coefficients(const Visit& visit) {
    visit(
        "Ratio", r, 1., 1e3,
        "r in W = mu/2 (k + (r - 1) k^2/(m + k)) + lambda/2 (ln J)^2 with k = I1 - 3 - 2 ln J: how "
        "much stiffer stretched tissue is. Units: none. The default is an example.");
    visit("Transition", m, 1e-3, 1e3,
          "m in W, see 'Ratio': the k at which three quarters of the change are over. Units: none. "
          "The default is an example.");
  }

  template <typename T>
  PROSUP_LAW_INLINE T distortion_energy(T mu, T I1, T log_J) const {
    const T k = I1 - 3. - 2. * log_J;
    return 0.5 * mu * (k + uniform<T>(r - 1.) * k * k / (uniform<T>(m) + k));
  }
  template <typename T>
  PROSUP_LAW_INLINE StressCoefficients<T> distortion_stress(T mu, T I1, T log_J) const {
    const T k = I1 - 3. - 2. * log_J, sum = uniform<T>(m) + k;
    const T mu_s = mu * (1. + uniform<T>(r - 1.) * k * (k + uniform<T>(2. * m)) / (sum * sum));
    return {mu_s, -mu_s};
  }
  template <typename T>
  PROSUP_LAW_INLINE TangentCoefficients<T> distortion_tangent(T mu, T I1, T log_J) const {
    const T sum = uniform<T>(m) + I1 - 3. - 2. * log_J;
    const T slope = mu * uniform<T>(4. * (r - 1.) * m * m) / (sum * sum * sum); // 2 mu ds/dk
    return {slope, -slope, slope};
  }
};

} // namespace prosup::mechanics

#endif
