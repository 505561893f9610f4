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

/// Backtracking: halves the part of a step that is taken until it lowers the
/// residual `norm`, where `norm_after(part)` is the norm after that part or
/// infinite. @returns the part, 0 if there is none.
template <typename NormAfter>
double accepted_part(double norm, const NormAfter& norm_after) {
  constexpr unsigned max_halvings = 12;
  constexpr double least_decrease = 1e-4;
  double part = 1.;
  for (unsigned i = 0; i <= max_halvings; ++i, part *= 0.5)
    if (norm_after(part) <= (1. - least_decrease * part) * norm)
      return part;
  return 0.;
}

} // namespace prosup::mechanics

#endif
