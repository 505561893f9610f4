#include "prosup/evaluation/error_bar.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "prosup/core/error.h"
#include "prosup/core/log.h"

namespace prosup::evaluation {

using dealii::Tensor;

namespace {

/// The 95th percentile of the chi-square distribution with `freedom` degrees of freedom, 1 to 3:
/// the parabola through 3.841, 5.991 and 7.815, which is right to 0.01 in between.
double chi_square_95(double freedom) {
  const double n = freedom - 2.;
  return 5.9915 + 1.9868 * n - 0.1634 * n * n;
}

/// A covariance has no negative variance, nor a NaN.
bool is_covariance(const Covariance& covariance) {
  bool is = true;
  for (unsigned i = 0; i < 3; ++i)
    is = is && covariance[i][i] >= 0.;
  return is && std::isfinite(covariance.norm());
}

void check(const std::vector<Covariance>& covariances, const PointMapper& mapper,
           Position position) {
  if (covariances.size() != mapper.n_nodes() ||
      !std::all_of(covariances.begin(), covariances.end(), is_covariance))
    throw Error(
        std::string("The ") + name_of(position) +
        " mesh needs one finite covariance for each of its nodes; repeat the registration.");
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

Uncertainty::Uncertainty(const PointMapper& prone, const PointMapper& supine,
                         Covariances covariances)
    : mappers_{&prone, &supine}, covariances_(std::move(covariances)) {
  for (const Position position : both_positions)
    check(covariances_[position], *mappers_[position], position);
}

Covariance Uncertainty::unloaded(const Point<3>& X) const {
  Covariance mean;
  for (const Position position : both_positions) {
    const MeshPlace place = mappers_[position]->place(X);
    for (unsigned a = 0; a < 4; ++a)
      mean += 0.5 * place.weights[a] * covariances_[position][place.nodes[a]];
  }
  return mean;
}

Covariance Uncertainty::loaded(const Point<3>& X, Position position) const {
  const Tensor<2, 3> F = mappers_[position]->place(X).gradient;
  return symmetrize(F * Tensor<2, 3>(unloaded(X)) * transpose(F));
}

} // namespace prosup::evaluation
