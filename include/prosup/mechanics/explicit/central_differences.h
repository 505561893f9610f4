#ifndef PROSUP_MECHANICS_CENTRAL_DIFFERENCES_H
#define PROSUP_MECHANICS_CENTRAL_DIFFERENCES_H

#include <vector>

#include "prosup/mechanics/body/body.h"
#include "prosup/mechanics/body/supports.h"
#include "prosup/mechanics/element/internal_force.h"
#include "prosup/mechanics/explicit/critical_step.h"

namespace prosup::mechanics {

/// Masses of the nodes and the step that is stable with them.
struct StableMass {
  std::vector<double> mass;    ///< inertial mass of each local node, g
  double critical_step = 0.;   ///< s
  double scaled_fraction = 0.; ///< part of the nodes whose mass was raised
};

/// Lumped masses rho V_a and their critical step, from the highest frequency. A
/// few badly shaped elements would limit the step. Therefore the masses of the
/// fraction `scaled_fraction` of the nodes with the smallest 2 sqrt(m_a / k_a) are
/// raised to what the step of the other nodes needs; k_a is
/// InternalForce::stiffness_bound plus the springs of the supports. The settled
/// state does not depend on the masses. Collective.
StableMass stable_mass(const Supports& supports, const InternalForce& internal_force,
                       HighestFrequency& highest_frequency, const NodeVector& displacement,
                       double density, double scaled_fraction);

/// Figures of the last step, over all ranks of the body.
struct StepReport {
  double min_jacobian = 0.;   ///< smallest J
  double kinetic_energy = 0.; ///< g mm^2/s^2
  double residual_norm = 0.;  ///< |sum of forces| of the free nodes, g mm/s^2
};

/// Explicit central differences with damping proportional to the velocity, eq. 6
/// of the paper. With the mid-step velocity v = (u^n+1 - u^n)/h,
///   v^n+1/2 = (v^n-1/2 + h f/m) / (1 + h r/rho),  u^n+1 = u^n + h v^n+1/2,
/// where f is the external minus the internal force.
class CentralDifferences {
public:
  /// Keeps references.
  CentralDifferences(const Supports& supports, const InternalForce& internal_force);

  /// Has to be called when the supports have come to hold other nodes.
  void update_fixed();

  /// Sets the masses, and the step to `safety` times the critical one.
  void set_mass(const StableMass& mass, double safety);
  void set_damping(double rate) { damping_rate_ = rate; } ///< r/rho, 1/s

  double time_step() const { return time_step_; }
  /// Inertial mass of each local node, g.
  const std::vector<double>& mass() const { return mass_; }

  /// Advances `displacement` by one step under `external_force` (g mm/s^2), both at
  /// owned nodes; ghosts keep the values before the step. Returns the smallest J of
  /// this rank before the step. Collective.
  double step(const NodeVector& external_force, NodeVector& displacement);

  /// Energy and residual of the last step. Collective.
  StepReport report() const;

  /// Sum of all forces of the last step, zero at fixed nodes and tangential at
  /// sliding ones, g mm/s^2.
  const NodeVector& force() const { return force_; }
  NodeVector& velocity() { return velocity_; }
  const NodeVector& velocity() const { return velocity_; }

private:
  const Body& body_;
  const Supports& supports_;
  const InternalForce& internal_force_;
  std::vector<double> mass_;
  double time_step_ = 0.;
  double damping_rate_ = 0.;
  double min_jacobian_ = 1.;
  std::vector<double> mobility_; // 1 for free owned nodes, 0 for fixed ones
  NodeVector force_;
  NodeVector velocity_;
};

} // namespace prosup::mechanics

#endif
