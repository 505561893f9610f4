// Error bars of points on two meshes.

#include <algorithm>
#include <cmath>
#include <utility>

#include "prosup/core/error.h"
#include "prosup/evaluation/error_bar.h"

namespace prosup::evaluation {

using dealii::Tensor;

namespace {

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
