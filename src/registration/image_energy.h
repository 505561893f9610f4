#ifndef PROSUP_REGISTRATION_IMAGE_ENERGY_H
#define PROSUP_REGISTRATION_IMAGE_ENERGY_H

#include <array>
#include <memory>
#include <vector>

#include "prosup/mechanics/static/elastic_metric.h"
#include "prosup/registration/body_pair.h"
#include "prosup/registration/similarity_setup.h"

namespace prosup::registration {

/// Positions X, or changes of them or forces on them, of the owned nodes of each state
/// that is held; empty for others.
using StateVectors = std::array<mechanics::NodeVector, 2>;

/// to += factor * what.
void add(StateVectors& to, double factor, const StateVectors& what);

/// What is known of a pair of unloaded positions.
struct ImageEnergyPoint {
  StateVectors unloaded;                   ///< X
  StateVectors elastic_force;              ///< K (X - X0)
  double elastic_energy = 0.;              ///< 1/2 (X - X0)^T K (X - X0), both states
  bool is_allowed = false;                 ///< no element is near inversion
  similarity::SimilarityResult similarity; ///< if allowed

  double value(double kappa) const { return kappa * similarity.value + elastic_energy; }
  /// -dphi/dX, g mm/s^2.
  StateVectors descent(double kappa) const;
};

/// phi(X) = kappa S(X) + 1/2 sum_states (X - X0)^T K (X - X0) on one image level, S
/// being the similarity and X0 the positions without image forces. Functions are collective
/// on the world of the pair.
class ImageEnergy {
public:
  /// X0 are the present positions of the pair. Elements have to keep J = det dx/dX above
  /// `smallest_jacobian`.
  ImageEnergy(BodyPair& pair, const SimilaritySetup& setup, double smallest_jacobian);

  /// Of the similarity from now on.
  void set_level(const similarity::Scene& scene, double level);

  /// `with_stiffness`: also that of the images.
  ImageEnergyPoint evaluate(StateVectors unloaded, bool with_stiffness) const;

  /// (K + factor H)^-1 force in the displacements that the supports allow, H being the
  /// stiffness of the images or, if empty, none.
  using ImageStiffness = std::array<std::vector<mechanics::CellStiffness>, 2>;
  StateVectors solve(const ImageStiffness& stiffness, double factor,
                     const StateVectors& force) const;

  /// a . b over the nodes of both states.
  double product(const StateVectors& a, const StateVectors& b) const;

private:
  double sum_of_states(const std::array<double, 2>& values) const;

  BodyPair& pair_;
  const SimilaritySetup& setup_;
  const double smallest_jacobian_;
  std::array<std::unique_ptr<mechanics::ElasticMetric>, 2> metric_;
  StateVectors start_; // X0
  similarity::SimilarityDomain domain_;
  std::array<image::ScalarImage, 2> images_;
};

} // namespace prosup::registration

#endif
