#ifndef PROSUP_MECHANICS_NEWTON_H
#define PROSUP_MECHANICS_NEWTON_H

#include <algorithm>
#include <limits>
#include <memory>
#include <string>

#include "equilibrium.h"

namespace prosup::mechanics {

/// How Newton's method went, and where it stopped.
struct NewtonReport {
  bool converged = false;
  unsigned n_steps = 0;
  unsigned n_linear_iterations = 0;
  double residual_norm = std::numeric_limits<double>::infinity(); ///< g mm/s^2
};

/// When to stop.
struct NewtonLimits {
  double residual_norm = 0.; ///< g mm/s^2
  unsigned max_steps = 0;
};

/// Newton's method with backtracking: a step after which some J is not
/// positive, or the residual far too high, is shortened.
class NewtonSolver {
public:
  virtual ~NewtonSolver() = default;
  /// Solves `equations` from `unknown` (ghosts in and out). Collective.
  virtual NewtonReport solve(const Equilibrium& equations, NodeVector& unknown,
                             const NewtonLimits& limits) = 0;
};

enum class LinearSolver { direct, multigrid };

/// PETSc: SNES with MUMPS, or GMRES and GAMG.
std::unique_ptr<NewtonSolver> make_petsc_newton(const Equilibrium& equations, LinearSolver solver);

/// Trilinos: own loop with Amesos, or GMRES and ML.
std::unique_ptr<NewtonSolver> make_trilinos_newton(const Equilibrium& equations,
                                                   LinearSolver solver);

/// Relative accuracy of the iterative linear solvers, and their patience.
constexpr double linear_tolerance = 1e-4;
constexpr unsigned max_linear_iterations = 400, linear_restart = 60;

/// Decides how much of each step of one solution is taken. The residual need not
/// fall at once: a step that rotates a nearly incompressible body changes volumes
/// in second order, against a bulk stiffness so high that the residual rises, and
/// the next steps mend that. It may not rise without bound nor stay up.
class Backtracking {
public:
  /// Halves the part of a step from where the residual is `norm`, until that
  /// after it, `norm_after(part)` (infinite where invalid), is acceptable.
  /// @returns the part, 0 if there is none.
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
