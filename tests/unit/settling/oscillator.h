#ifndef PROSUP_TESTS_SETTLING_OSCILLATOR_H
#define PROSUP_TESTS_SETTLING_OSCILLATOR_H

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include "prosup/settling/simulation.h"

namespace prosup::tests {

/// A mass of 1 on a spring that was imaged at x under gravity: u'' + r u' + k u = g. The unloaded
/// position is x - g/k. It can be told to go wrong.
class Oscillator : public settling::Simulation {
public:
  static constexpr double x = 10., k = 100., g = 300.;

  // How it goes wrong.
  double largest_load = 1e9;        ///< fraction of gravity that it bears
  double largest_safety = 1e9;      ///< it collapses with larger steps under the full load ...
  unsigned collapse_after = 0;      ///< ... once it has done so many steps
  unsigned strength_that_rests = 0; ///< it swings forever unless damping is strengthened so often
  bool mends_itself = false;        ///< with a sufficient remedy, which also ends the collapse
  bool is_held = false;

  // What was done to it.
  double unloaded = x, displacement = 0., velocity = 0.;
  double safety = 0., last_part = 0., restored = 0.;
  unsigned n_steps = 0, strength = 0, n_mended = 0, n_restored = 0;

  static double exact() { return x - g / k; }

  settling::Report advance(unsigned n, double gravity_ramp) override {
    const double h = time_step(), r = damping_rate();
    loading_ += gravity_ramp > 0. ? n * h * r / gravity_ramp : 1.;
    load_ = from_ + (to_ - from_) * std::min(1., loading_);
    double force = 0.;
    for (unsigned i = 0; i < n; ++i) {
      force = load_ * g - k * displacement;
      velocity = (velocity + h * force) / (1. + h * r);
      displacement += h * velocity;
    }
    n_steps += n;
    if (strength < strength_that_rests) // an undamped swing about the state at rest
      displacement = load_ * g / k + 0.5 * std::sin(std::sqrt(k) * h * n_steps);
    settling::Report report;
    report.residual = std::abs(load_ * g - k * displacement) / g;
    report.distance = is_held ? 0. : std::abs(x - displacement - unloaded);
    report.min_jacobian = collapses() ? -1. : 0.5;
    report.kinetic_energy = 0.5 * velocity * velocity / (g * x);
    report.is_fully_loaded = loading_ >= 1.;
    return report;
  }
  void correct(double part) override {
    last_part = part;
    unloaded += part * (x - displacement - unloaded);
  }
  void update_time_step(double new_safety) override { safety = new_safety; }
  /// As if some other mode limited it.
  double time_step() const override { return 0.004 * safety; }
  double damping_rate() const override { return 2. * std::sqrt(k); }
  double largest_displacement() const override { return std::abs(displacement); }
  bool holds_reference() const override { return is_held; }
  bool has_gravity() const override { return true; }

  settling::Snapshot take_snapshot() const override {
    return std::make_shared<const State>(State{unloaded, displacement, velocity, loading_});
  }
  void restore(const settling::Snapshot& snapshot) override {
    const State& state = *static_cast<const State*>(snapshot.get());
    unloaded = state.unloaded;
    displacement = state.displacement;
    velocity = state.velocity;
    loading_ = state.loading;
    ++n_restored;
    restored = unloaded;
  }
  void stop() override { velocity = 0.; }
  void load_between(double from, double to) override {
    from_ = from;
    to_ = to;
    loading_ = 0.;
  }
  settling::Remedy mend(settling::Trouble trouble, bool) override {
    if (!mends_itself || trouble != settling::Trouble::divergence)
      return {};
    ++n_mended;
    largest_safety = 1e9;
    return {"a new spring", true};
  }
  void strengthen_damping() override { ++strength; }
  std::string worst_cell() override { return "cell 7"; }
  std::string softness() const override { return "soft as butter"; }

private:
  struct State {
    double unloaded, displacement, velocity, loading;
  };

  bool collapses() const {
    return load_ > largest_load ||
           (safety > largest_safety && loading_ >= 1. && n_steps > collapse_after);
  }

  double loading_ = 0., load_ = 0., from_ = 0., to_ = 1.;
};

} // namespace prosup::tests

#endif
