#ifndef PROSUP_MECHANICS_DAMPING_H
#define PROSUP_MECHANICS_DAMPING_H

#include <string>
#include <vector>

#include "prosup/mechanics/explicit/central_differences.h"

namespace prosup::mechanics {

/// How motion is taken out of an explicit simulation that is to settle. With M
/// the inertial mass, f the internal forces:
enum class DampingScheme {
  fixed,            ///< r/rho as it is given
  lowest_frequency, ///< r/rho = 2 omega, omega^2 = u.f / u.M u (Rayleigh quotient of u)
  adaptive,         ///< the same with the increments of u and f (adaptive dynamic relaxation:
                    ///< Underwood 1983; Oakley and Knight 1995)
  kinetic           ///< none, but velocities set to zero where the kinetic energy has a peak
};

/// The schemes that can be chosen by name, in the order of the enumerators.
const std::vector<std::string>& damping_names();

/// Adjusts the damping of an integrator from time to time. Collective.
class DampingControl {
public:
  /// `first_rate` is r/rho of the fixed scheme, and of the others until they know
  /// better, 1/s.
  DampingControl(DampingScheme scheme, double first_rate, const Body& body);

  /// r/rho at present, 1/s.
  double rate() const { return rate_; }
  /// The rate, 1/s, in which the simulation settles: that of the damping, or the
  /// first one where there is none.
  double time_scale() const { return rate_ > 0. ? rate_ : first_rate_; }

  /// Peaks of the kinetic energy are seen by looking at every step; the others
  /// change slowly.
  bool watches_every_step() const { return scheme_ == DampingScheme::kinetic; }

  /// Looks at the state after a step of `integrator` under `external_force` and
  /// sets its damping.
  void update(CentralDifferences& integrator, const NodeVector& displacement,
              const NodeVector& external_force);

  /// From now on twice the rate that follows the lowest frequency, once: it makes
  /// settling slower, and bodies bear more in which other modes flutter.
  void strengthen() { frequency_factor_ = 4.; }

  /// A fixed rate that is more than three times too high or too low for the body to
  /// settle follows the lowest frequency from now on. @returns whether it does.
  bool mend_fixed_rate(CentralDifferences& integrator, const NodeVector& displacement,
                       const NodeVector& external_force);

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
