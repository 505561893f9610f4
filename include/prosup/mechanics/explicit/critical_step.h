#ifndef PROSUP_MECHANICS_CRITICAL_STEP_H
#define PROSUP_MECHANICS_CRITICAL_STEP_H

#include <vector>

#include "prosup/mechanics/body/body.h"
#include "prosup/mechanics/body/node_memory.h"
#include "prosup/mechanics/element/internal_force.h"

namespace prosup::mechanics {

/// Largest eigenvalue omega^2 of K phi = omega^2 M phi by Lanczos' method, where K
/// is the tangent of the internal forces at a displacement. The Ritz value theta
/// converges from below; with the norm r of its residual,
///   theta <= omega^2_max <= theta + r.
/// The upper bound holds once the Ritz vector belongs to the top of the spectrum: a
/// rough start vector, a converged residual and a minimum number of iterations in
/// the first call ensure this. Products with K are differences of internal forces.
class HighestFrequency {
public:
  /// Bounds of the largest eigenvalue, and what they took.
  struct Estimate {
    double ritz_value = 0.;  ///< theta, 1/s^2
    double upper_bound = 0.; ///< theta + r, 1/s^2
    unsigned n_products = 0; ///< products with K, two internal forces each

    /// A stable step of central differences from the upper bound, s. `added` (1/s^2)
    /// is a bound on what other forces add to omega^2.
    double critical_step(double added = 0.) const;
  };

  HighestFrequency(const Body& body, const InternalForce& internal_force);

  /// Iterates until r < `tolerance` theta, for `mass` (g) and `fixed` at the local
  /// nodes. The next call starts from the Ritz vector of this one. Collective.
  Estimate estimate(const NodeVector& displacement, const std::vector<double>& mass,
                    const std::vector<bool>& fixed, double tolerance = 0.03);

  /// The vector that the next call starts from, for a simulation that goes on in another process.
  void store(NodeMemory& memory) const;
  /// @throws Error if it is missing.
  void recall(const NodeMemory& memory);

private:
  NodeVector product(const NodeVector& displacement, const NodeVector& direction) const;

  const Body& body_;
  const InternalForce& internal_force_;
  NodeVector rough_, start_; ///< in the coordinates M^1/2 u
  bool has_found_top_ = false;
};

} // namespace prosup::mechanics

#endif
