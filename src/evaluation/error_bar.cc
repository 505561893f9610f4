#include "prosup/evaluation/error_bar.h"

#include <algorithm>
#include <cmath>

#include "prosup/core/log.h"

namespace prosup::evaluation {

namespace {

/// The 95th percentile of the chi-square distribution with `freedom` degrees of freedom, 1 to 3:
/// the parabola through 3.841, 5.991 and 7.815, which is right to 0.01 in between.
double chi_square_95(double freedom) {
  const double n = freedom - 2.;
  return 5.9915 + 1.9868 * n - 0.1634 * n * n;
}

} // namespace

ErrorBar error_bar(const Covariance& covariance) {
  ErrorBar bar;
  for (unsigned d = 0; d < 3; ++d)
    bar.deviation[d] = std::sqrt(std::max(covariance[d][d], 0.));
  const double mean = trace(covariance), square = covariance * covariance;
  if (mean > 0.)
    bar.radius_95 =
        std::sqrt(square / mean * chi_square_95(std::clamp(mean * mean / square, 1., 3.)));
  return bar;
}

std::string described(const ErrorBar& error) {
  return format("95 %% within %.2f mm; standard deviations %.2f, %.2f, %.2f mm (L, P, S)",
                error.radius_95, error.deviation[0], error.deviation[1], error.deviation[2]);
}

} // namespace prosup::evaluation
