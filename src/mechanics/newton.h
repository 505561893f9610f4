#ifndef PROSUP_MECHANICS_NEWTON_H
#define PROSUP_MECHANICS_NEWTON_H

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
/// positive, or that does not lower the residual, is shortened.
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

/// Backtracking stops after this many shorter steps.
constexpr unsigned max_shortenings = 12;

} // namespace prosup::mechanics

#endif
