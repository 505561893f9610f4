#include "simulation.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "prosup/core/error.h"

namespace prosup::unloading {

using namespace dealii;
using mechanics::node_value;

namespace {

// A body that slides and has never settled gets as many returns with more caution before its chest
// is held.
constexpr unsigned troubles_before_holding = 3;

} // namespace

settling::Report Unloading::Simulation::advance(unsigned n_steps, double gravity_ramp) {
  const double duration = n_steps * integrator_.time_step();
  state_.time += duration;
  state_.loading += gravity_ramp > 0. ? duration * damping_.time_scale() / gravity_ramp : 1.;
  update_external_force();
  supports_.contacts().linearize(state_.unloaded, state_.displacement);
  collapse_watch_.restart();
  for (unsigned i = 0; i < n_steps; ++i) {
    collapse_watch_.look(integrator_.step(external_force_, state_.displacement),
                         state_.displacement);
    if (damping_.watches_every_step() || i + 1 == n_steps)
      damping_.update(integrator_, state_.displacement, external_force_);
  }
  return report();
}

settling::Report Unloading::Simulation::report() const {
  const mechanics::StepReport step = integrator_.report();
  settling::Report result;
  result.residual = step.residual_norm / weight_norm_;
  result.distance = holds_reference_ ? 0. : max_distance();
  result.min_jacobian = Utilities::MPI::min(collapse_watch_.min_jacobian(), body_.communicator());
  result.kinetic_energy = has_gravity() ? step.kinetic_energy / free_fall_energy_ : 0.;
  if (!std::isfinite(step.kinetic_energy))
    result.kinetic_energy = step.kinetic_energy;
  result.is_fully_loaded = is_fully_loaded_;
  result.has_inverted_reference = !(reference_volume_ > 0.);
  return result;
}

void Unloading::Simulation::correct(double part) {
  const NodeVector& loaded = body_.vertex_positions();
  state_.displacement.update_ghost_values();
  for (unsigned i = 0; i < 3 * body_.n_local_nodes(); ++i) {
    double& X = state_.unloaded.local_element(i);
    X += part * (loaded.local_element(i) - state_.displacement.local_element(i) - X);
  }
  supports_.contacts().put_on_surfaces(state_.unloaded);
  update_reference();
}

void Unloading::Simulation::update_reference() {
  reference_volume_ =
      Utilities::MPI::min(internal_force_.set_reference(state_.unloaded), body_.communicator());
  supports_.set_reference(state_.unloaded);
  nodal_volume_ = internal_force_.nodal_volume();
  double weight = 0.;
  for (unsigned node = 0; node < body_.n_owned_nodes(); ++node)
    if (!supports_.fixed()[node])
      weight += (parameters_.density * nodal_volume_[node] * gravity_).norm_square();
  weight_norm_ = std::sqrt(Utilities::MPI::sum(weight, body_.communicator()));
  if (!(weight_norm_ > 0.)) // without gravity residuals are absolute
    weight_norm_ = 1.;
}

void Unloading::Simulation::update_time_step(double safety) {
  const mechanics::StableMass stable =
      mechanics::stable_mass(supports_, internal_force_, highest_frequency_, state_.displacement,
                             parameters_.density, parameters_.scaled_fraction);
  if (!(stable.critical_step > 0.)) { // an element is inverted: the next steps will tell
    if (integrator_.time_step() > 0.)
      return;
    throw DivergenceError("The unloading of " + name_ +
                          " cannot start: an element of its mesh is inverted; check the mesh.");
  }
  integrator_.set_mass(stable, safety);
  double mass = 0.;
  for (unsigned node = 0; node < body_.n_owned_nodes(); ++node)
    mass += parameters_.density * nodal_volume_[node];
  free_fall_energy_ = Utilities::MPI::sum(mass, body_.communicator()) * largest_head_;
}

void Unloading::Simulation::update_external_force() {
  const double gravity_part =
      gravity_from_ + (gravity_to_ - gravity_from_) * std::min(1., state_.loading);
  const double since = state_.time - state_.ramp_start;
  const double increment_part = state_.ramp_time > 0. ? std::min(1., since / state_.ramp_time) : 1.;
  is_fully_loaded_ = state_.loading >= 1. && increment_part == 1.;
  for (unsigned node = 0; node < body_.n_owned_nodes(); ++node)
    for (unsigned c = 0; c < 3; ++c) {
      const unsigned i = 3 * node + c;
      external_force_.local_element(i) =
          gravity_part * parameters_.density * nodal_volume_[node] * gravity_[c] +
          state_.force.local_element(i) + increment_part * state_.force_increment.local_element(i);
    }
}

double Unloading::Simulation::max_distance() const {
  double largest = 0.;
  for (unsigned node = 0; node < body_.n_owned_nodes(); ++node)
    largest = std::max(largest,
                       (node_value(body_.vertex_positions(), node) -
                        node_value(state_.displacement, node) - node_value(state_.unloaded, node))
                           .norm_square());
  return std::sqrt(Utilities::MPI::max(largest, body_.communicator()));
}

double Unloading::Simulation::largest_displacement() const {
  double largest = 0.;
  for (unsigned node = 0; node < body_.n_owned_nodes(); ++node)
    largest = std::max(largest, node_value(state_.displacement, node).norm_square());
  return std::sqrt(Utilities::MPI::max(largest, body_.communicator()));
}

Unloading::Snapshot Unloading::Simulation::save() const {
  Snapshot result = state_;
  result.velocity = integrator_.velocity();
  return result;
}

settling::Snapshot Unloading::Simulation::take_snapshot() const {
  return std::make_shared<const Snapshot>(save());
}

void Unloading::Simulation::restore(const settling::Snapshot& snapshot) {
  restore(*static_cast<const Snapshot*>(snapshot.get()));
}

void Unloading::Simulation::restore(const Snapshot& snapshot) {
  state_ = snapshot;
  state_.unloaded.update_ghost_values();
  state_.displacement.update_ghost_values();
  integrator_.velocity() = snapshot.velocity;
  update_reference();
}

void Unloading::Simulation::stop() {
  state_.velocity = 0.;
  integrator_.velocity() = 0.;
}

void Unloading::Simulation::load_between(double from, double to) {
  gravity_from_ = from;
  gravity_to_ = to;
  state_.loading = 0.;
}

/// A fixed damping rate that is far off keeps a body from settling, and so do single nodes that
/// jump to and fro on a chest without a clear normal.
settling::Remedy Unloading::Simulation::mend(settling::Trouble trouble, bool gives_up_early) {
  if (!gives_up_early && !loop_.has_settled() && ++n_troubles_ == troubles_before_holding)
    if (const settling::Remedy held = hold_chest(); held.starts_anew)
      return held;
  if (trouble != settling::Trouble::stall)
    return {};
  if (damping_.mend_fixed_rate(integrator_, state_.displacement, external_force_))
    return {"damping from the lowest frequency"};
  return hold_stalled_nodes();
}

std::string Unloading::Simulation::worst_cell() {
  state_.displacement.update_ghost_values();
  return collapse_watch_.worst_cell(state_.displacement);
}

std::string Unloading::Simulation::softness() const {
  return format("rho g L/mu = %.2g", parameters_.density * largest_head_ / mean_shear_modulus_);
}

} // namespace prosup::unloading
