#include "prosup/similarity/local_correlation.h"

#include <deal.II/base/patterns.h>

#include <algorithm>
#include <cmath>

#include "prosup/core/error.h"
#include "prosup/core/log.h"
#include "window_sum.h"

namespace prosup::similarity {

namespace {

/// Coefficients of the slopes. After distribute(),
///   dS/dP_v = own.prone P_v + cross S_v + constant.prone, and likewise for S.
/// Before, they hold the contribution of each window, in which P_v and S_v are measured
/// from the means, so that the constants are -own.prone P_mean - cross S_mean.
struct Coefficients {
  PerPosition<Field> own, constant;
  Field cross;

  explicit Coefficients(std::size_t n) : cross(n, 0.f) {
    for (const Position p : both_positions)
      own[p] = constant[p] = cross;
  }

  /// Gives each voxel the sums over the windows that it is in.
  void distribute(WindowSum& sum) {
    sum.apply(cross);
    for (const Position p : both_positions)
      for (Field* field : {&own[p], &constant[p]})
        sum.apply(*field);
  }
};

/// Sums of powers of the intensities over the window around each voxel.
struct Moments {
  Field count, product;
  PerPosition<Field> value, square;

  Moments(const WarpedPair& pair, WindowSum& sum) {
    const std::size_t n = pair.in_domain.size();
    count.assign(n, 0.f);
    product = value.prone = value.supine = square.prone = square.supine = count;
    for (std::size_t v = 0; v < n; ++v) {
      if (!pair.in_domain[v])
        continue;
      count[v] = 1.f;
      product[v] = pair.values.prone[v] * pair.values.supine[v];
      for (const Position p : both_positions) {
        value[p][v] = pair.values[p][v];
        square[p][v] = pair.values[p][v] * pair.values[p][v];
      }
    }
    for (Field* field :
         {&count, &product, &value.prone, &value.supine, &square.prone, &square.supine})
      sum.apply(*field);
  }

  /// Squared correlation in the window around v, and its contribution to `result`.
  double correlation(std::size_t v, double noise_variance, Coefficients& result) const {
    const double n = count[v];
    PerPosition<double> mean, variance;
    for (const Position p : both_positions) {
      mean[p] = value[p][v] / n;
      variance[p] = std::max(square[p][v] / n - mean[p] * mean[p], 0.) + noise_variance;
    }
    const double covariance = product[v] / n - mean.prone * mean.supine;
    const double cross = -covariance / (variance.prone * variance.supine);
    const double squared = -covariance * cross;
    result.cross[v] = static_cast<float>(cross / n);
    for (const Position p : both_positions) {
      const double own = squared / variance[p];
      result.own[p][v] = static_cast<float>(own / n);
      result.constant[p][v] = static_cast<float>(-(own * mean[p] + cross * mean[other(p)]) / n);
    }
    return squared;
  }
};

} // namespace

LocalCorrelation::LocalCorrelation(double window_radius, double noise)
    : window_radius_(window_radius), noise_(noise) {
  if (!(window_radius > 0.) || !std::isfinite(window_radius))
    throw Error(format("The windows of lncc reach %g mm, but must reach more than 0 mm; change "
                       "'Similarity/lncc/Window radius'.",
                       window_radius));
  if (!(noise > 0.) || !std::isfinite(noise))
    throw Error(format(
        "The noise of lncc is %g, but must be positive; change 'Similarity/lncc/Noise'.", noise));
}

void LocalCorrelation::declare_parameters(dealii::ParameterHandler& prm) {
  prm.enter_subsection(name());
  prm.add_parameter("Window radius", window_radius_,
                    "Half the edge of the cubic windows, at least one voxel. Small windows work "
                    "best, since they rarely hold air, fat and gland at once. Units: mm.",
                    dealii::Patterns::Double(0.1, 1000.));
  prm.add_parameter("Noise", noise_,
                    "Standard deviation of the noise: windows in which the images vary less hardly "
                    "count. Units: none (images are scaled to [0, 1]).",
                    dealii::Patterns::Double(1e-6, 1.));
  prm.leave_subsection();
}

double LocalCorrelation::evaluate(const WarpedPair& pair, VoxelDerivatives& derivatives) const {
  const std::size_t n_voxels = pair.in_domain.size();
  derivatives.reset(n_voxels);
  WindowSum sum(pair.grid, window_radius_);
  Coefficients coefficients(n_voxels);
  const Moments moments(pair, sum);
  const double noise_variance = noise_ * noise_;
  double uncorrelated = 0.;
  for (std::size_t v = 0; v < n_voxels; ++v)
    if (pair.in_domain[v])
      uncorrelated += 1. - moments.correlation(v, noise_variance, coefficients);
  coefficients.distribute(sum);

  const auto factor = static_cast<float>(scale * pair.grid.voxel_volume());
  for (const Position p : both_positions) {
    const Field &own = coefficients.own[p], &constant = coefficients.constant[p];
    const std::vector<float>&here = pair.values[p], &there = pair.values[other(p)];
    for (std::size_t v = 0; v < n_voxels; ++v)
      if (pair.in_domain[v]) {
        derivatives.slope[p][v] =
            factor * (own[v] * here[v] + coefficients.cross[v] * there[v] + constant[v]);
        // Rounding of the running sums may leave less than zero.
        derivatives.curvature[p][v] = std::max(0.f, factor * own[v]);
      }
  }
  return 0.5 * scale * pair.grid.voxel_volume() * uncorrelated;
}

} // namespace prosup::similarity
