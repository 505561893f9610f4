#ifndef PROSUP_REGISTRATION_GAUSS_NEWTON_H
#define PROSUP_REGISTRATION_GAUSS_NEWTON_H

#include <array>
#include <memory>

#include "prosup/core/log.h"
#include "prosup/mechanics/elastic_metric.h"
#include "prosup/registration/body_pair.h"
#include "prosup/registration/similarity_setup.h"

namespace prosup::registration {

struct GaussNewtonParameters {
  double weight = 1.;
  unsigned max_updates = 20;
  double least_gain = 0.005;
  double smallest_jacobian = 0.2;
  double tolerance = 1e-2;
  bool free_anchor = false;
};

/// Moves the unloaded positions X of both states to where
///   phi(X) = kappa S(X) + 1/2 sum_states (X - X0)^T K (X - X0)
/// is smallest.
class GaussNewton {
public:
  GaussNewton(const GaussNewtonParameters& parameters, BodyPair& pair, const SimilaritySetup& setup,
              const Log& log);

  void run_level(const similarity::Scene& scene, double level, double shear_modulus,
                 std::vector<SimilarityRecord>& history);
  void finish();

private:
  using Positions = std::array<mechanics::NodeVector, 2>;
  struct Point {
    Positions unloaded;
    similarity::SimilarityResult similarity;
    Positions elastic_force; ///< K (X - X0)
    double energy = 0.;
    double min_jacobian = 0.;
  };

  Point evaluate(const similarity::SimilarityDomain& domain,
                 const std::array<image::ScalarImage, 2>& images, Positions unloaded) const;
  Positions step(const Point& point, double kappa) const;
  double sum_of_states(const std::array<double, 2>& values) const;

  const GaussNewtonParameters& parameters_;
  BodyPair& pair_;
  const SimilaritySetup& setup_;
  const Log& log_;
  std::array<std::unique_ptr<mechanics::ElasticMetric>, 2> metric_;
  Positions start_, present_;
};

} // namespace prosup::registration

#endif
