#include "runs.h"

#include <cmath>

#include "prosup/core/error.h"
#include "prosup/core/log.h"
#include "prosup/unloading/unloading.h"

namespace prosup::benchmarks {

using namespace dealii;
using mechanics::NodeVector;
using settling::CorrectionScheme;
using unloading::Unloading;

namespace {

struct Parameters : unloading::UnloadingParameters {
  explicit Parameters(const Run& run, unsigned n_steps) {
    correction = settling::correction_names()[static_cast<unsigned>(run.correction.scheme)];
    lag_factor = run.correction.lag_factor;
    correction_interval = run.correction.interval;
    damping = "fixed";
    damping_rate = run.damping_rate;
    scaled_fraction = 0.;
    step_safety = run.step_safety;
    max_retries = 0;
    max_steps = n_steps;
    residual_tolerance = 1e-4;
    position_tolerance = 0.005;
  }
};

/// Puts the simulation next to Newton's solution, fully loaded and at rest.
void start_from_solution(Unloading& simulation, const HalfBall& breast) {
  constexpr double disturbance = 1e-3; // of the displacement
  Unloading::Snapshot state = simulation.save();
  for (unsigned i = 0; i < state.displacement.locally_owned_size(); ++i) {
    const double u =
        breast.body.vertex_positions().local_element(i) - breast.unloaded.local_element(i);
    state.displacement.local_element(i) = (1. + disturbance * std::sin(7. * i)) * u;
    state.unloaded.local_element(i) = breast.unloaded.local_element(i);
  }
  state.loading = 1e3;
  simulation.restore(state);
  simulation.set_material(breast.material); // masses and step of this reference
}

} // namespace

std::string Correction::name() const {
  return scheme == CorrectionScheme::full ? "full, n = " + std::to_string(interval)
                                          : format("relaxed, lag %g", lag_factor);
}

const char* name_of(Outcome outcome) {
  switch (outcome) {
  case Outcome::converged:
    return "converged";
  case Outcome::unsettled:
    return "unsettled";
  case Outcome::diverged:
    break;
  }
  return "diverged";
}

void simulate(const HalfBall& breast, Run& run, unsigned max_steps, bool from_solution) {
  const Parameters parameters(run, max_steps);
  mechanics::Supports supports(breast.body, {1});
  Unloading simulation(parameters, supports, breast.gravity);
  simulation.set_observer([&](unsigned n_steps) {
    run.n_steps = n_steps;
    return true;
  });
  try {
    simulation.set_material(breast.material);
    run.interval_time = run.correction.interval * simulation.time_step() * run.damping_rate;
    if (from_solution)
      start_from_solution(simulation, breast);
    const bool converged = simulation.run().converged;
    run.outcome = converged ? Outcome::converged : Outcome::unsettled;
    run.error = max_distance(simulation.unloaded(), breast.unloaded);
  } catch (const DivergenceError&) {
    run.outcome = Outcome::diverged;
  }
}

double observed_critical_damping(const HalfBall& breast, double low, double high) {
  while (high > 1.01 * low) {
    Run run;
    run.correction = {CorrectionScheme::full, 1., 1};
    run.damping_rate = std::sqrt(low * high);
    run.step_safety = 0.4;
    simulate(breast, run, 40000, true);
    (run.outcome == Outcome::converged ? high : low) = run.damping_rate;
  }
  return std::sqrt(low * high);
}

} // namespace prosup::benchmarks
