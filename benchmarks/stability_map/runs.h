#ifndef PROSUP_BENCHMARKS_STABILITY_MAP_RUNS_H
#define PROSUP_BENCHMARKS_STABILITY_MAP_RUNS_H

#include <string>
#include <vector>

#include "breast.h"
#include "prosup/unloading/unloading_parameters.h"

namespace prosup::benchmarks {

/// A way of correcting: the relaxed one with a lag, or the full one every n steps.
struct Correction {
  settling::CorrectionScheme scheme;
  double lag_factor;
  unsigned interval;

  std::string name() const;
};

enum class Outcome { converged, unsettled, diverged };
const char* name_of(Outcome outcome);

/// One simulation.
struct Run {
  unsigned n_cells = 0;
  bool prone = true;
  double softness = 0.;       ///< rho g L/mu
  double damping_factor = 0.; ///< (r/rho)/(2 omega_1)
  double damping_rate = 0.;   ///< r/rho, 1/s
  Correction correction{};
  double step_safety = 0.9; ///< of the critical step
  Outcome outcome = Outcome::unsettled;
  unsigned n_steps = 0;
  double interval_time = 0.; ///< n h r/rho
  double error = 0.;         ///< max distance from Newton's solution, mm
};

/// Unloads, without retries and with fixed damping, starting from X = x, or next
/// to Newton's solution: there what linear theory says has to be seen.
void simulate(const HalfBall& breast, Run& run, unsigned max_steps, bool from_solution = false);

/// Damping rate r/rho (1/s) at which the full correction of every step begins to
/// be stable near Newton's solution, by bisection to 1 percent between bounds.
/// Steps are short, so that only the flutter is seen.
double observed_critical_damping(const HalfBall& breast, double low, double high);

} // namespace prosup::benchmarks

#endif
