#ifndef PROSUP_EVALUATION_ERROR_BAR_H
#define PROSUP_EVALUATION_ERROR_BAR_H

#include <deal.II/base/symmetric_tensor.h>

#include <string>
#include <vector>

#include "prosup/core/position.h"
#include "prosup/evaluation/point_mapper.h"

namespace prosup::evaluation {

/// A covariance of positions, mm^2.
using Covariance = dealii::SymmetricTensor<2, 3>;

/// How sure a mapped point is.
struct ErrorBar {
  dealii::Tensor<1, 3> deviation; ///< standard deviations along x, y, z (LPS), mm
  double radius_95 = 0.; ///< of the ball around the point that holds the truth with 95 %, mm
};

/// The error bar of a point with normally distributed error. The radius is that of the chi-square
/// distribution with the mean and the variance of the squared distance (Satterthwaite), which is
/// exact for errors along a line, in a plane and in space that are equal in all directions.
ErrorBar error_bar(const Covariance& covariance);

/// In words, for the description of a point.
std::string described(const ErrorBar& error);

/// The uncertainty of a finished registration: the covariance of the distance between the unloaded
/// positions that the prone and the supine image give one piece of tissue, at the nodes of both
/// meshes. Keeps references to the mappers.
class Uncertainty {
public:
  using Covariances = PerPosition<std::vector<Covariance>>; ///< of each node

  /// @throws Error if there is not one covariance for each node, or one is no covariance.
  Uncertainty(const PointMapper& prone, const PointMapper& supine, Covariances covariances);

  /// At the unloaded position X: the mean of both meshes, each interpolated linearly between its
  /// nodes, or that of its closest surface point outside.
  Covariance unloaded(const Point<3>& X) const;

  /// The same as a distance in the loaded configuration of a position: F C F^T, F = dx/dX.
  Covariance loaded(const Point<3>& X, Position position) const;

private:
  PerPosition<const PointMapper*> mappers_;
  Covariances covariances_;
};

} // namespace prosup::evaluation

#endif
