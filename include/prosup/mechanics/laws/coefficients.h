#ifndef PROSUP_MECHANICS_COEFFICIENTS_H
#define PROSUP_MECHANICS_COEFFICIENTS_H

// What the laws and the kernels share. The kernels are compiled with -ffast-math and once for
// each instruction set, so that the headers of the laws include neither deal.II nor the standard
// library, and all their functions are inlined: nothing compiled in a kernel may replace a
// function of another file.
#define PROSUP_LAW_INLINE inline __attribute__((always_inline))

namespace prosup::mechanics {

// A law gives the energy density as a function of I1 = tr(F^T F) and ln J, J = det F, in two parts,
//   W = distortion(I1, ln J) + volume(ln J),
// the first proportional to the shear modulus mu, the second to lambda. Its functions are
// templates on T, which is double or a vector of GCC, so that plain code and kernels share them:
//
//   static constexpr const char* name           its name in Material/Model
//   void coefficients(visit)                    calls visit(name, value, minimum, maximum, text)
//                                               for each parameter of the law other than mu and
//                                               lambda; these form the section Material/<section>
//   T distortion_energy(mu, I1, log_J)
//   StressCoefficients<T> distortion_stress(mu, I1, log_J)
//   TangentCoefficients<T> distortion_tangent(mu, I1, log_J)
//   T volume_energy(lambda, log_J), volume_slope(...), volume_curvature(...)
//
// At F = 1 there is no stress, and the tangent is that of linear elasticity with mu and lambda.

/// Coefficients of the first Piola-Kirchhoff stress P = a F + b F^-T of an energy W(I1, ln J).
template <typename T>
struct StressCoefficients {
  T a; ///< 2 dW/dI1
  T b; ///< dW/d(ln J)
};

/// Second derivatives of W. With those of the stress they give the derivative of P,
///   dP = a dF - b F^-T dF^T F^-T + [aa F:dF + ab F^-T:dF] F + [ab F:dF + bb F^-T:dF] F^-T.
/// A law with aa = 0 has ab = 0.
template <typename T>
struct TangentCoefficients {
  T aa; ///< 4 d2W/dI1^2
  T ab; ///< 2 d2W/(dI1 d(ln J))
  T bb; ///< d2W/d(ln J)^2
};

/// The type of one lane of T.
template <typename T>
struct LaneOf {
  using Type = decltype(+T()[0]);
};
/// A number is its own lane.
template <>
struct LaneOf<double> {
  using Type = double;
};

/// `value` in all lanes.
template <typename T>
PROSUP_LAW_INLINE T uniform(double value) {
  return T{} + static_cast<typename LaneOf<T>::Type>(value);
}

} // namespace prosup::mechanics

#endif
