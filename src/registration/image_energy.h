#ifndef PROSUP_SRC_REGISTRATION_IMAGE_ENERGY_H
#define PROSUP_SRC_REGISTRATION_IMAGE_ENERGY_H

#include <memory>
#include <vector>

#include "prosup/mechanics/static/elastic_metric.h"
#include "prosup/registration/comparison.h"
#include "prosup/similarity/image_force.h"
#include "step_limit.h"

namespace prosup::registration {

/// Positions X of the owned nodes of each breast that is held, or changes of them or forces on
/// them; empty for others.
using PairVectors = PerPosition<mechanics::NodeVector>;

/// to += factor * what.
void add(PairVectors& to, double factor, const PairVectors& what);
/// vectors *= factor.
void scale(PairVectors& vectors, double factor);

/// What is known of a pair of unloaded positions.
struct ImageEnergyPoint {
  PairVectors unloaded;                    ///< X
  PairVectors elastic_force;               ///< K (X - X0)
  double elastic_energy = 0.;              ///< 1/2 (X - X0)^T K (X - X0), both breasts
  bool is_allowed = false;                 ///< no element is near inversion
  similarity::SimilarityResult similarity; ///< if allowed

  double value(double kappa) const { return kappa * similarity.value + elastic_energy; }
  /// -dphi/dX, g mm/s^2.
  PairVectors descent(double kappa) const;
};

/// phi(X) = kappa S(X) + 1/2 sum_breasts (X - X0)^T K (X - X0) on one image level, S being the
/// dissimilarity and X0 the positions without image forces. For breasts of finite elements
/// (Breast::elements()). Functions are collective on the world of the pair.
class ImageEnergy {
public:
  /// X0 are the present positions of the pair, or those given. Elements have to keep J = det dx/dX
  /// within the bounds.
  ImageEnergy(const BreastPair& pair, const JacobianBounds& bounds, const PairVectors& start = {});

  /// X0.
  const PairVectors& start() const { return start_; }
  /// Of the nodes of both breasts from there, root mean square, mm.
  double distance(const ImageEnergyPoint& point) const;

  /// Measures the dissimilarity by `comparison` from now on, which has to live as long as it is
  /// used.
  void compare_by(const Comparison& comparison);

  /// `with_stiffness`: also that of the images.
  ImageEnergyPoint evaluate(PairVectors unloaded, bool with_stiffness) const;

  /// From these positions along a direction, as far as the bounds of J let each node go.
  PairVectors moved(const PairVectors& from, double length, const PairVectors& direction) const;

  /// (K + factor H)^-1 force in the displacements that the supports allow, H being the stiffness
  /// of the images or, if empty, none.
  using ImageStiffness = PerPosition<std::vector<mechanics::CellStiffness>>;
  PairVectors solve(const ImageStiffness& stiffness, double factor, const PairVectors& force) const;

  /// a . b over the nodes of both breasts.
  double product(const PairVectors& a, const PairVectors& b) const;

private:
  double sum_over_breasts(const PerPosition<double>& values) const;

  const BreastPair& pair_;
  const JacobianBounds bounds_;
  PerPosition<std::unique_ptr<mechanics::ElasticMetric>> metric_;
  PairVectors start_; // X0
  const Comparison* comparison_ = nullptr;
  std::unique_ptr<similarity::ImageForce> image_force_;
};

} // namespace prosup::registration

#endif
