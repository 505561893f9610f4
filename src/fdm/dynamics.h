#ifndef PROSUP_SRC_FDM_DYNAMICS_H
#define PROSUP_SRC_FDM_DYNAMICS_H

#include <array>
#include <utility>
#include <vector>

#include "prosup/fdm/vector_field.h"
#include "slab.h"
#include "stencil_kernel.h"

namespace prosup::fdm {

/// Explicit time integration by the paper's eq. 6 on one slab of the grid.
class Dynamics {
public:
  using Vectors = std::array<NodalField, 3>;

  Dynamics(const Slab& slab, double density);

  /// Sets which nodes move; the others keep their displacement.
  void set_mobile(const std::vector<bool>& moves);
  bool is_mobile(std::size_t node) const { return mobile_[node]; }

  /// Sets h_t, s; the increments are scaled so that velocities stay the same.
  void set_time_step(double time_step);
  double time_step() const { return time_step_; }
  /// Sets r/rho, 1/s.
  void set_damping(double rate);

  /// 1 + h_t r/rho
  double friction() const { return 1. + time_step_ * damping_; }

  /// Computes the next increments from displacements, maps and forces, which have to be
  /// up to date in the neighbours' planes. Returns this rank's smallest J.
  double advance_increments();
  /// Adds the increments to the displacements and exchanges them with the neighbours.
  void move();
  /// Acceleration K at an owned node, from the increments before and after
  /// advance_increments(), mm/s^2.
  Tensor<1, 3> acceleration(const Vectors& before, std::size_t node) const;

  /// This rank's critical time step 2/omega in the present state, s. With c = mu + lambda (1 - ln
  /// J) and G = F^-1,
  ///   omega^2 <= 4/(rho h^2) (3 mu + c |G G^T|),
  /// the frequency of the shortest wave along all three axes on this grid.
  double critical_time_step() const;

  Vectors displacement; ///< u, mm
  Vectors increment;    ///< U^n - U^{n-1}, mm
  Vectors force;        ///< f, body force per mass, mm/s^2
  NodalField mu, lambda;

private:
  const Slab& slab_;
  const kernel::Step<Real> step_;
  const double density_;
  double time_step_ = 0., damping_ = 0.;
  std::vector<bool> mobile_;
  NodalField mobility_;                                   ///< 1/friction(), 0 where a node is held
  std::vector<std::pair<std::size_t, std::size_t>> runs_; ///< of nodes, most of which move
};

} // namespace prosup::fdm

#endif
