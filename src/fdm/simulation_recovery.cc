// Snapshots of the simulation, and what makes it safer.

#include <algorithm>
#include <limits>

#include "simulation.h"

namespace prosup::fdm {

namespace {

constexpr double stiffest_background = 0.1; // over that of the softest tissue

// More damping makes settling too slow.
constexpr double largest_damping_factor = 16.;

} // namespace

struct FdmUnloading::Simulation::State {
  Dynamics::Vectors displacement, increment, pull_back;
  double time_step, time, loading; // the time step is that of the increments
  ForceRecord force_record;
};

FdmUnloading::Snapshot FdmUnloading::Simulation::take_snapshot() const {
  return std::make_shared<const State>(State{dynamics_.displacement, dynamics_.increment,
                                             pull_back_, dynamics_.time_step(), time_, loading_,
                                             force_record_});
}

/// The time step is then that of the snapshot, and should be updated.
void FdmUnloading::Simulation::restore(const Snapshot& snapshot) {
  const State& state = *static_cast<const State*>(snapshot.get());
  dynamics_.displacement = state.displacement;
  dynamics_.set_time_step(state.time_step);
  dynamics_.increment = state.increment;
  pull_back_ = state.pull_back;
  time_ = state.time;
  loading_ = state.loading;
  force_record_ = state.force_record;
  force_record_.write_again();
  force_record_.update(time_, maps_);
  resample();
}

void FdmUnloading::Simulation::stop() {
  for (NodalField& component : dynamics_.increment)
    std::fill(component.begin(), component.end(), Real(0));
}

void FdmUnloading::Simulation::load_between(double from, double to) {
  gravity_from_ = from;
  gravity_to_ = to;
  loading_ = 0.;
}

/// What diverges first is usually the jump of stiffness at the skin.
settling::Remedy FdmUnloading::Simulation::mend(settling::Trouble trouble, bool) {
  if (trouble != settling::Trouble::divergence || background_stiffness_ >= stiffest_background)
    return {};
  background_stiffness_ = std::min(2. * background_stiffness_, stiffest_background);
  maps_.set_material(material_, background_stiffness_);
  return {"stiffer air", true};
}

void FdmUnloading::Simulation::strengthen_damping() {
  damping_factor_ = std::min(2. * damping_factor_, largest_damping_factor);
}

std::string FdmUnloading::Simulation::worst_cell() {
  return format("smallest J = %.2g", min_jacobian_);
}

std::string FdmUnloading::Simulation::softness() const {
  double mu = std::numeric_limits<double>::max();
  for (const auto& tissue : material_.tissues)
    mu = std::min(mu, tissue.second.mu);
  return format("rho g L/mu = %.2g", density_ * head_ / mu);
}

} // namespace prosup::fdm
