#include "prosup/similarity/local_correlation.h"

#include <algorithm>
#include <cmath>

#include "prosup/core/error.h"
#include "prosup/core/log.h"
#include "window_sum.h"

namespace prosup::similarity {

namespace {

/// What the slopes are made of: after distribute(),
///   dS/dP_v = own[0] P_v + cross S_v + constant[0], and likewise for S.
/// It first holds the parts of each window, in which P_v and S_v are measured
/// from the means, so that the constants are -own[0] P_mean - cross S_mean.
struct Coefficients {
  std::array<Field, 2> own, constant;
  Field cross;

  explicit Coefficients(std::size_t n) : cross(n, 0.f) {
    for (unsigned s = 0; s < 2; ++s)
      own[s] = constant[s] = cross;
  }

  /// Gives each voxel the sums over the windows that it is in.
  void distribute(WindowSum& sum) {
    sum.apply(cross);
    for (unsigned s = 0; s < 2; ++s)
      for (Field* field : {&own[s], &constant[s]})
        sum.apply(*field);
  }
};

/// Sums of powers of the intensities over the window around each voxel.
struct Moments {
  Field count, product;
  std::array<Field, 2> value, square;

  Moments(const WarpedPair& pair, WindowSum& sum) {
    const std::size_t n = pair.in_domain.size();
    count.assign(n, 0.f);
    product = value[0] = value[1] = square[0] = square[1] = count;
    for (std::size_t v = 0; v < n; ++v) {
      if (!pair.in_domain[v])
        continue;
      count[v] = 1.f;
      product[v] = pair.values[0][v] * pair.values[1][v];
      for (unsigned s = 0; s < 2; ++s) {
        value[s][v] = pair.values[s][v];
        square[s][v] = pair.values[s][v] * pair.values[s][v];
      }
    }
    for (Field* field : {&count, &product, &value[0], &value[1], &square[0], &square[1]})
      sum.apply(*field);
  }

  /// Squared correlation in the window around v, and its parts of `result`.
  double correlation(std::size_t v, double noise_variance, Coefficients& result) const {
    const double n = count[v];
    double mean[2], variance[2];
    for (unsigned s = 0; s < 2; ++s) {
      mean[s] = value[s][v] / n;
      variance[s] = std::max(square[s][v] / n - mean[s] * mean[s], 0.) + noise_variance;
    }
    const double covariance = product[v] / n - mean[0] * mean[1];
    const double cross = -covariance / (variance[0] * variance[1]);
    const double squared = -covariance * cross;
    result.cross[v] = static_cast<float>(cross / n);
    for (unsigned s = 0; s < 2; ++s) {
      const double own = squared / variance[s];
      result.own[s][v] = static_cast<float>(own / n);
      result.constant[s][v] = static_cast<float>(-(own * mean[s] + cross * mean[1 - s]) / n);
    }
    return squared;
  }
};

} // namespace

LocalCorrelation::LocalCorrelation(double window_radius, double noise)
    : window_radius_(window_radius), noise_variance_(noise * noise) {
  if (!(window_radius > 0.) || !std::isfinite(window_radius))
    throw Error(format("The windows of lncc reach %g mm, but must reach more than 0 mm; change "
                       "'Similarity/Window radius'.",
                       window_radius));
  if (!(noise > 0.) || !std::isfinite(noise))
    throw Error(
        format("The noise of lncc is %g, but must be positive; change 'Similarity/Noise'.", noise));
}

double LocalCorrelation::evaluate(const WarpedPair& pair, VoxelDerivatives& derivatives) const {
  const std::size_t n_voxels = pair.in_domain.size();
  derivatives.reset(n_voxels);
  WindowSum sum(pair.grid, window_radius_);
  Coefficients coefficients(n_voxels);
  const Moments moments(pair, sum);
  double uncorrelated = 0.;
  for (std::size_t v = 0; v < n_voxels; ++v)
    if (pair.in_domain[v])
      uncorrelated += 1. - moments.correlation(v, noise_variance_, coefficients);
  coefficients.distribute(sum);

  const auto factor = static_cast<float>(scale * pair.grid.voxel_volume());
  for (unsigned s = 0; s < 2; ++s)
    for (std::size_t v = 0; v < n_voxels; ++v)
      if (pair.in_domain[v]) {
        derivatives.slope[s][v] =
            factor * (coefficients.own[s][v] * pair.values[s][v] +
                      coefficients.cross[v] * pair.values[1 - s][v] + coefficients.constant[s][v]);
        // Rounding of the running sums may leave less than zero.
        derivatives.curvature[s][v] = std::max(0.f, factor * coefficients.own[s][v]);
      }
  return 0.5 * scale * pair.grid.voxel_volume() * uncorrelated;
}

} // namespace prosup::similarity
