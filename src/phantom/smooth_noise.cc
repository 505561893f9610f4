#include "prosup/phantom/smooth_noise.h"

#include <array>
#include <cmath>

namespace prosup::phantom {

namespace {

constexpr unsigned n_knots = 32; // along each axis; a power of two

/// Weights of the four knots around a position at t in [0, 1) of its interval.
std::array<double, 4> spline_weights(double t) {
  const double s = 1. - t;
  return {s * s * s / 6., (4. - 6. * t * t + 3. * t * t * t) / 6.,
          (4. - 6. * s * s + 3. * s * s * s) / 6., t * t * t / 6.};
}

/// Mean over all positions of the sum of the squared weights in one dimension:
/// the variance that coefficients of variance one leave.
constexpr double variance_per_axis = 151. / 315.;

} // namespace

SmoothNoise::SmoothNoise(double spacing, std::uint64_t seed, Stream stream, unsigned part)
    : spacing_(spacing), coefficients_(n_knots * n_knots * n_knots) {
  Random random(seed, stream, part);
  const double scale = std::pow(variance_per_axis, -1.5);
  for (float& coefficient : coefficients_)
    coefficient = static_cast<float>(scale * random.normal());
}

double SmoothNoise::operator()(const dealii::Point<3>& position) const {
  std::array<std::array<double, 4>, 3> weights;
  std::array<std::array<unsigned, 4>, 3> knots;
  for (unsigned d = 0; d < 3; ++d) {
    const double q = position[d] / spacing_, start = std::floor(q);
    weights[d] = spline_weights(q - start);
    const auto first = static_cast<long>(start) - 1;
    for (unsigned a = 0; a < 4; ++a)
      knots[d][a] = static_cast<unsigned>(first + a) % n_knots;
  }
  double value = 0.;
  for (unsigned c = 0; c < 4; ++c)
    for (unsigned b = 0; b < 4; ++b) {
      const float* row = &coefficients_[n_knots * (knots[1][b] + n_knots * knots[2][c])];
      double sum = 0.;
      for (unsigned a = 0; a < 4; ++a)
        sum += weights[0][a] * row[knots[0][a]];
      value += weights[1][b] * weights[2][c] * sum;
    }
  return value;
}

} // namespace prosup::phantom
