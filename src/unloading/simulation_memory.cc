// What a simulation goes on from in another process.

#include "simulation.h"

namespace prosup::unloading {

namespace {

/// The fields and numbers of a snapshot, by name.
template <typename State, typename Work>
void for_each_field(State& state, const Work& work) {
  work("unloaded", state.unloaded);
  work("displacement", state.displacement);
  work("velocity", state.velocity);
  work("force", state.force);
  work("force_increment", state.force_increment);
}

template <typename State, typename Work>
void for_each_number(State& state, const Work& work) {
  work("time", state.time);
  work("ramp_start", state.ramp_start);
  work("ramp_time", state.ramp_time);
  work("loading", state.loading);
}

} // namespace

mechanics::NodeMemory Unloading::Simulation::memory() const {
  const Snapshot present = save();
  mechanics::NodeMemory memory;
  for_each_field(present,
                 [&](const char* name, const NodeVector& field) { memory.fields[name] = field; });
  for_each_number(present, [&](const char* name, double number) { memory.numbers[name] = number; });
  NodeVector& mass = memory.fields["mass"]; // its first component
  body_.initialize(mass);
  for (unsigned node = 0; node < body_.n_owned_nodes(); ++node)
    mass.local_element(3 * node) = integrator_.mass()[node];
  NodeVector& held = memory.fields["held"]; // 1 in its first component
  body_.initialize(held);
  for (unsigned node = 0; node < body_.n_owned_nodes() && !held_.empty(); ++node)
    held.local_element(3 * node) = held_[node] ? 1. : 0.;
  memory.numbers["time_step"] = integrator_.time_step();
  memory.numbers["holds_reference"] = holds_reference_ ? 1. : 0.;
  damping_.store(memory);
  highest_frequency_.store(memory);
  memory.numbers.merge(loop_.memory());
  return memory;
}

void Unloading::Simulation::recall(const mechanics::NodeMemory& memory) {
  Snapshot snapshot;
  for_each_field(snapshot,
                 [&](const char* name, NodeVector& field) { field = memory.field(name); });
  for_each_number(snapshot,
                  [&](const char* name, double& number) { number = memory.number(name); });
  restore(snapshot);
  NodeVector at_nodes = memory.field("held");
  at_nodes.update_ghost_values();
  std::vector<bool> held(body_.n_local_nodes());
  for (unsigned node = 0; node < held.size(); ++node)
    held[node] = at_nodes.local_element(3 * node) > 0.;
  hold(held);
  at_nodes = memory.field("mass");
  at_nodes.update_ghost_values();
  mechanics::StableMass mass;
  for (unsigned node = 0; node < body_.n_local_nodes(); ++node)
    mass.mass.push_back(at_nodes.local_element(3 * node));
  mass.critical_step = memory.number("time_step");
  integrator_.set_mass(mass, 1.);
  holds_reference_ = memory.number("holds_reference") > 0.;
  damping_.recall(memory, integrator_);
  highest_frequency_.recall(memory);
  loop_.set_memory(memory.numbers);
}

} // namespace prosup::unloading
