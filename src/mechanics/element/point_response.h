#ifndef PROSUP_MECHANICS_POINT_RESPONSE_H
#define PROSUP_MECHANICS_POINT_RESPONSE_H

#include <deal.II/base/tensor.h>

#include <cmath>

#include "prosup/mechanics/laws/material.h"

namespace prosup::mechanics {

/// Stress and tangent of a law at one deformation gradient, in the coefficients of
/// coefficients.h, Pa.
struct PointResponse {
  StressCoefficients<double> stress;
  TangentCoefficients<double> tangent;
};

/// The response of the part of the law that depends on the distortion. `J` = det F > 0.
template <typename L>
PointResponse distortion_response(const L& law, const LameParameters& parameters,
                                  const dealii::Tensor<2, 3>& F, double J) {
  const double I1 = scalar_product(F, F), log_J = std::log(J);
  return {law.distortion_stress(parameters.mu, I1, log_J),
          law.distortion_tangent(parameters.mu, I1, log_J)};
}

/// The response of the law. `J` = det F > 0.
template <typename L>
PointResponse response(const L& law, const LameParameters& parameters,
                       const dealii::Tensor<2, 3>& F, double J) {
  PointResponse result = distortion_response(law, parameters, F, J);
  result.stress.b += law.volume_slope(parameters.lambda, std::log(J));
  result.tangent.bb += law.volume_curvature(parameters.lambda, std::log(J));
  return result;
}

} // namespace prosup::mechanics

#endif
