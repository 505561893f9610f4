#ifndef PROSUP_MECHANICS_DAMPING_H
#define PROSUP_MECHANICS_DAMPING_H

#include <string>
#include <vector>

#include "prosup/mechanics/body/node_memory.h"
#include "prosup/mechanics/explicit/central_differences.h"

namespace prosup::mechanics {

/// How an explicit simulation is damped until it settles. M is the inertial mass, f the
/// internal forces:
enum class DampingScheme {
  fixed,            ///< a given r/rho
  lowest_frequency, ///< r/rho = 2 omega, omega^2 = u.f / u.M u (Rayleigh quotient of u)
  adaptive,         ///< the same with the increments of u and f (adaptive dynamic relaxation:
                    ///< Underwood 1983; Oakley and Knight 1995)
  kinetic           ///< no damping; velocities are set to zero at each peak of kinetic energy
};

/// Names of the schemes in parameters, in the order of the enumerators.
const std::vector<std::string>& damping_names();

/// Sets the damping of an integrator in the course of a simulation. All functions with an
/// integrator are collective.
class DampingControl {
public:
  /// `first_rate` (1/s) is r/rho of the fixed scheme, and of the others until their first update.
  DampingControl(DampingScheme scheme, double first_rate, const Body& body);

  /// Present r/rho, 1/s.
  double rate() const { return rate_; }
  /// Rate at which the simulation settles, 1/s: the present r/rho, or the first one where that is
  /// zero.
  double time_scale() const { return rate_ > 0. ? rate_ : first_rate_; }

  /// Whether update() has to be called after every step. Only kinetic damping needs that, in order
  /// not to miss a peak.
  bool watches_every_step() const { return scheme_ == DampingScheme::kinetic; }

  /// Sets the damping of `integrator` from its state after a step under `external_force`.
  void update(CentralDifferences& integrator, const NodeVector& displacement,
              const NodeVector& external_force);

  /// Doubles the rate that is derived from the lowest frequency, from now on and once only. The
  /// body settles more slowly, but higher modes are damped better.
  void strengthen() { frequency_factor_ = 4.; }

  /// Changes the scheme from fixed to lowest_frequency if the fixed rate differs by more than a
  /// factor of three from the rate of that scheme. @returns whether it changed.
  bool mend_fixed_rate(CentralDifferences& integrator, const NodeVector& displacement,
                       const NodeVector& external_force);

  /// What the rate came from, for a simulation that goes on in another process.
  void store(NodeMemory& memory) const;
  /// Sets the damping of `integrator` too. @throws Error if something is missing.
  void recall(const NodeMemory& memory, CentralDifferences& integrator);

private:
  double frequency(const CentralDifferences& integrator, const NodeVector& displacement,
                   const NodeVector& external_force);

  DampingScheme scheme_;
  const Body& body_;
  const double first_rate_;
  double rate_;
  double frequency_factor_ = 2.; // r/rho over omega
  double last_kinetic_energy_ = 0.;
  NodeVector last_displacement_, last_internal_force_;
};

} // namespace prosup::mechanics

#endif
