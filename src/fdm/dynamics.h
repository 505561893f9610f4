#ifndef PROSUP_SRC_FDM_DYNAMICS_H
#define PROSUP_SRC_FDM_DYNAMICS_H

#include <array>
#include <utility>
#include <vector>

#include "prosup/fdm/vector_field.h"
#include "slab.h"
#include "stencil_kernel.h"

namespace prosup::fdm {

/// The time stepping of the paper's eq. 6 on one slab of the grid.
class Dynamics {
public:
  using Vectors = std::array<NodalField, 3>;

  Dynamics(const Slab& slab, double density);

  /// Which nodes move: others keep their displacement.
  void set_mobile(const std::vector<bool>& moves);
  bool is_mobile(std::size_t node) const { return mobile_[node]; }

  /// h_t, s. Velocities are kept.
  void set_time_step(double time_step);
  double time_step() const { return time_step_; }
  /// r/rho, 1/s.
  void set_damping(double rate);

  /// 1 + h_t r/rho
  double friction() const { return 1. + time_step_ * damping_; }

  /// Finds the next increments from displacements, maps and forces, which have to
  /// be known in the neighbours' planes too. Returns this rank's smallest J.
  double advance_increments();
  /// Adds the increments to the displacements and exchanges these.
  void move();
  /// K at owned nodes from the increments before and after advance_increments().
  Tensor<1, 3> acceleration(const Vectors& before, std::size_t node) const;

  /// The highest critical time step 2/omega at which the simulation is stable at
  /// present, s; of this rank. With c = mu + lambda (1 - ln J) and G = F^-1,
  ///   omega^2 <= 4/(rho h^2) (3 mu + c |G G^T|),
  /// the value of the stencils for the shortest wave along all three axes.
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
