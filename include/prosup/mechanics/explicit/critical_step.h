#ifndef PROSUP_MECHANICS_CRITICAL_STEP_H
#define PROSUP_MECHANICS_CRITICAL_STEP_H

#include <vector>

#include "prosup/mechanics/body/body.h"
#include "prosup/mechanics/element/internal_force.h"

namespace prosup::mechanics {

/// Largest eigenvalue omega^2 of K phi = omega^2 M phi, K being the tangent of
/// the internal forces at a displacement, by Lanczos' method. The Ritz value
/// converges from below; with the norm of its residual r it gives
///   theta <= omega^2_max <= theta + r,
/// the upper bound as soon as the Ritz vector has found the top of the spectrum. A
/// rough start vector, a converged residual and patience in the first call make
/// sure of that. Products with K are differences of internal forces.
class HighestFrequency {
public:
  struct Estimate {
    double ritz_value = 0.;  ///< theta, 1/s^2
    double upper_bound = 0.; ///< theta + r, 1/s^2
    unsigned n_products = 0; ///< with K, two evaluations of the internal force each

    /// Largest stable step of central differences, s; not above the true one.
    /// `added` (1/s^2) is a bound on what other forces add to omega^2.
    double critical_step(double added = 0.) const;
  };

  HighestFrequency(const Body& body, const InternalForce& internal_force);

  /// For `mass` (g) and `fixed` at local nodes. The Ritz vector is kept to start
  /// from in the next call. Collective.
  /// Stops when r is below `tolerance` theta.
  Estimate estimate(const NodeVector& displacement, const std::vector<double>& mass,
                    const std::vector<bool>& fixed, double tolerance = 0.03);

private:
  NodeVector product(const NodeVector& displacement, const NodeVector& direction) const;

  const Body& body_;
  const InternalForce& internal_force_;
  NodeVector rough_, start_; ///< in the coordinates M^1/2 u
  bool has_found_top_ = false;
};

} // namespace prosup::mechanics

#endif
