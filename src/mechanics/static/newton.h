#ifndef PROSUP_MECHANICS_NEWTON_H
#define PROSUP_MECHANICS_NEWTON_H

#include <algorithm>
#include <limits>
#include <memory>
#include <string>

#include "equilibrium.h"

namespace prosup::mechanics {

/// Result of Newton's method.
struct NewtonReport {
  bool converged = false;
  unsigned n_steps = 0;
  unsigned n_linear_iterations = 0;
  double residual_norm = std::numeric_limits<double>::infinity(); ///< g mm/s^2
};

/// Stopping criteria.
struct NewtonLimits {
  double residual_norm = 0.; ///< g mm/s^2
  unsigned max_steps = 0;
};

/// Newton's method with backtracking: a step is shortened if some J would not be positive after
/// it, or the residual far too high.
class NewtonSolver {
public:
  virtual ~NewtonSolver() = default;
  /// Solves `equations`, starting from `unknown`; ghosts are valid on entry and return. Collective.
  virtual NewtonReport solve(const Equilibrium& equations, NodeVector& unknown,
                             const NewtonLimits& limits) = 0;
};

enum class LinearSolver { direct, multigrid };

/// PETSc: SNES with MUMPS, or GMRES and GAMG.
std::unique_ptr<NewtonSolver> make_petsc_newton(const Equilibrium& equations, LinearSolver solver);

/// Trilinos: a loop of our own with Amesos, or GMRES and ML.
std::unique_ptr<NewtonSolver> make_trilinos_newton(const Equilibrium& equations,
                                                   LinearSolver solver);

/// Relative tolerance and limits of the iterative linear solvers.
constexpr double linear_tolerance = 1e-4;
constexpr unsigned max_linear_iterations = 400, linear_restart = 60;

/// Decides which fraction of each Newton step is taken. The residual need not fall in every step:
/// a step that rotates a nearly incompressible body changes volumes in second order, and the high
/// bulk stiffness makes the residual rise until the next steps correct it. It must neither rise
/// without bound nor stay high.
class Backtracking {
public:
  /// Halves the fraction of a step until the norm of the residual after it,
  /// `norm_after(fraction)` (infinite where invalid), is acceptable. `norm` is that before the
  /// step.
  /// @returns the fraction, 0 if none is acceptable.
  template <typename NormAfter>
  double accepted_part(double norm, const NormAfter& norm_after) {
    constexpr unsigned max_halvings = 12, patience = 6;
    constexpr double largest_growth = 1e4;
    n_steps_up_ = norm < lowest_norm_ ? 0 : n_steps_up_ + 1;
    lowest_norm_ = std::min(lowest_norm_, norm);
    double part = n_steps_up_ > patience ? 0. : 1.;
    for (unsigned i = 0; i <= max_halvings && part > 0.; ++i, part *= 0.5)
      if (norm_after(part) <= largest_growth * lowest_norm_)
        return part;
    return 0.;
  }

private:
  double lowest_norm_ = std::numeric_limits<double>::infinity();
  unsigned n_steps_up_ = 0; // since the residual was lowest
};

} // namespace prosup::mechanics

#endif
