#include "prosup/unloading/unloading.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "divergence_guard.h"
#include "prosup/core/error.h"

namespace prosup::unloading {

using namespace dealii;
using mechanics::node_value;

namespace {

constexpr unsigned corrections_per_snapshot = 10;

Tensor<1, 3> gravity_vector(const UnloadingParameters& parameters, const Tensor<1, 3>& direction) {
  if (!(direction.norm() > 0.))
    throw Error("The direction of gravity is (0, 0, 0); give a direction in LPS such as 0,-1,0 for "
                "prone and 0,1,0 for supine.");
  return parameters.gravity * direction / direction.norm();
}

} // namespace

Unloading::Unloading(const UnloadingParameters& parameters, mechanics::Supports& supports,
                     const Tensor<1, 3>& gravity_direction, std::string name, const Log& log)
    : parameters_(parameters), supports_(supports), body_(supports.body()),
      gravity_(gravity_vector(parameters, gravity_direction)), name_(std::move(name)), log_(log),
      internal_force_(body_), highest_frequency_(body_, internal_force_),
      integrator_(supports, internal_force_),
      damping_(parameters.damping_scheme(), parameters.damping_rate, body_),
      guard_(std::make_unique<DivergenceGuard>(parameters, body_, gravity_)) {
  if (!(parameters.damping_rate > 0.))
    throw Error(format("'Unloading/Damping rate' is %g; it has to be positive, as ramp and lag are "
                       "measured in it and nothing settles without damping.",
                       parameters.damping_rate));
  if (!supports.hold_anything())
    throw Error("Nothing holds " + name_ +
                ": its mesh has neither a chest wall nor cut planes, or both are set free; check "
                "the labels, 'Labels/Chest' and 'Supports/Cut planes'.");
  for (NodeVector* vector : {&state_.unloaded, &state_.displacement, &state_.velocity,
                             &state_.force, &state_.force_increment, &external_force_})
    body_.initialize(*vector);
  state_.unloaded = body_.vertex_positions();
  state_.unloaded.update_ghost_values();
  state_.displacement.update_ghost_values();
  integrator_.set_damping(parameters.damping_rate);
}

Unloading::~Unloading() = default;

void Unloading::set_material(const mechanics::Material& material) {
  guard_->set_material(material);
  internal_force_.set_material(material);
  update_reference();
  update_mass();
}

void Unloading::add_force(const NodeVector& increment, double ramp_time) {
  state_.force += state_.force_increment;
  std::copy_n(increment.begin(), 3 * body_.n_owned_nodes(), state_.force_increment.begin());
  state_.ramp_start = state_.time;
  state_.ramp_time = ramp_time;
}

double Unloading::adopt(const NodeVector& unloaded) {
  std::copy_n(unloaded.begin(), 3 * body_.n_owned_nodes(), state_.unloaded.begin());
  state_.unloaded.update_ghost_values();
  supports_.contacts().put_on_surfaces(state_.unloaded);
  const NodeVector& loaded = body_.vertex_positions();
  for (unsigned i = 0; i < 3 * body_.n_local_nodes(); ++i)
    state_.displacement.local_element(i) =
        loaded.local_element(i) - state_.unloaded.local_element(i);
  update_reference();
  integrator_.velocity() = 0.;
  state_.loading = 1.;
  state_.ramp_time = 0.;
  state_.force = 0.;
  state_.force_increment = 0.;
  update_external_force();
  supports_.contacts().linearize(state_.unloaded, state_.displacement);
  NodeVector out_of_balance = external_force_;
  const double jacobian = Utilities::MPI::min(
      internal_force_.subtract(state_.displacement, out_of_balance), body_.communicator());
  supports_.add_spring_forces(state_.displacement, out_of_balance);
  state_.force.add(-1., out_of_balance);
  return jacobian;
}

UnloadingResult Unloading::run() {
  return simulate(parameters_.max_steps, true);
}

UnloadingResult Unloading::advance(unsigned n_steps) {
  return simulate(n_steps, false);
}

UnloadingResult Unloading::simulate(unsigned max_steps, bool until_settled) {
  UnloadingResult result;
  guard_->begin(save());
  unsigned n_corrections = 0;
  while (result.n_steps < max_steps) {
    const unsigned n = std::min(parameters_.correction_interval, max_steps - result.n_steps);
    const double duration = n * integrator_.time_step();
    state_.time += duration;
    const double ramp = guard_->values().gravity_ramp;
    state_.loading += ramp > 0. ? duration * damping_.time_scale() / ramp : 1.;
    update_external_force();
    supports_.contacts().linearize(state_.unloaded, state_.displacement);
    min_jacobian_ = std::numeric_limits<double>::max();
    for (unsigned i = 0; i < n; ++i) {
      const double jacobian = integrator_.step(external_force_, state_.displacement);
      min_jacobian_ = std::min(min_jacobian_, jacobian);
      guard_->watch_step(jacobian, internal_force_, state_.displacement);
      if (damping_.watches_every_step() || i + 1 == n)
        damping_.update(integrator_, state_.displacement, external_force_);
    }
    result.n_steps += n;

    mechanics::StepReport report = integrator_.report();
    report.min_jacobian = Utilities::MPI::min(min_jacobian_, body_.communicator());
    if (const std::string trouble = guard_->trouble(report, reference_volume_); !trouble.empty()) {
      retreat(trouble, false, result);
      continue;
    }
    guard_->forget_steps();
    result.min_jacobian = report.min_jacobian;
    result.residual = report.residual_norm / weight_norm_;
    result.distance = holds_reference_ ? 0. : max_distance();
    log_.progress(format("  %s: step %u, residual %.1e, max |x-u-X| %.3f mm, min J %.2f",
                         name_.c_str(), result.n_steps, result.residual, result.distance,
                         result.min_jacobian));
    const double error = std::max(result.residual / parameters_.residual_tolerance,
                                  result.distance / parameters_.position_tolerance);
    const double tolerance = guard_->values().tolerance;
    result.converged =
        error < tolerance && fully_loaded_ &&
        result.residual * largest_displacement() < tolerance * parameters_.position_tolerance;
    has_settled_ = has_settled_ || result.converged;
    if ((result.converged && until_settled) || (observer_ && !observer_(result.n_steps)))
      break;
    if (until_settled && fully_loaded_ &&
        guard_->is_stalled(error, duration * damping_.time_scale(), result.n_steps)) {
      if (!recover_from_stall(error, result))
        break;
      continue;
    }
    if (++n_corrections % corrections_per_snapshot == 0 && fully_loaded_ && guard_->is_good(error))
      guard_->keep(save(), error);
    if (!holds_reference_)
      correct_unloaded_positions();
    if (n_corrections % guard_->values().mass_interval == 0)
      update_mass();
  }
  if (until_settled && !result.converged && result.explanation.empty())
    end_unsettled(result);
  return result;
}

void Unloading::correct_unloaded_positions() {
  const double lag = guard_->values().lag_factor / damping_.time_scale();
  const double beta =
      parameters_.correction_scheme() == CorrectionScheme::full
          ? 1.
          : std::min(1., parameters_.correction_interval * integrator_.time_step() / lag);
  const NodeVector& loaded = body_.vertex_positions();
  state_.displacement.update_ghost_values();
  for (unsigned i = 0; i < 3 * body_.n_local_nodes(); ++i) {
    double& X = state_.unloaded.local_element(i);
    X += beta * (loaded.local_element(i) - state_.displacement.local_element(i) - X);
  }
  supports_.contacts().put_on_surfaces(state_.unloaded);
  update_reference();
}

void Unloading::update_reference() {
  reference_volume_ =
      Utilities::MPI::min(internal_force_.set_reference(state_.unloaded), body_.communicator());
  supports_.set_reference(state_.unloaded);
  nodal_volume_ = internal_force_.nodal_volume();
  double weight = 0.;
  for (unsigned node = 0; node < body_.n_owned_nodes(); ++node)
    if (!supports_.fixed()[node])
      weight += (parameters_.density * nodal_volume_[node] * gravity_).norm_square();
  weight_norm_ = std::sqrt(Utilities::MPI::sum(weight, body_.communicator()));
  if (!(weight_norm_ > 0.)) // no gravity: residuals are then relative to any force
    weight_norm_ = 1.;
}

void Unloading::update_mass() {
  const mechanics::StableMass stable =
      mechanics::stable_mass(supports_, internal_force_, highest_frequency_, state_.displacement,
                             parameters_.density, parameters_.scaled_fraction);
  if (!(stable.critical_step > 0.)) { // an element is inverted: the next steps will tell
    if (integrator_.time_step() > 0.)
      return;
    throw DivergenceError("The unloading of " + name_ +
                          " cannot start: an element of its mesh is inverted; check the mesh.");
  }
  integrator_.set_mass(stable, guard_->values().step_safety);
  double mass = 0.;
  for (unsigned node = 0; node < body_.n_owned_nodes(); ++node)
    mass += parameters_.density * nodal_volume_[node];
  guard_->set_mass(Utilities::MPI::sum(mass, body_.communicator()));
}

void Unloading::update_external_force() {
  const double gravity_part =
      gravity_from_ + (gravity_to_ - gravity_from_) * std::min(1., state_.loading);
  const double since = state_.time - state_.ramp_start;
  const double increment_part = state_.ramp_time > 0. ? std::min(1., since / state_.ramp_time) : 1.;
  fully_loaded_ = state_.loading >= 1. && increment_part == 1.;
  for (unsigned node = 0; node < body_.n_owned_nodes(); ++node)
    for (unsigned c = 0; c < 3; ++c) {
      const unsigned i = 3 * node + c;
      external_force_.local_element(i) =
          gravity_part * parameters_.density * nodal_volume_[node] * gravity_[c] +
          state_.force.local_element(i) + increment_part * state_.force_increment.local_element(i);
    }
}

double Unloading::max_distance() const {
  double largest = 0.;
  for (unsigned node = 0; node < body_.n_owned_nodes(); ++node)
    largest = std::max(largest,
                       (node_value(body_.vertex_positions(), node) -
                        node_value(state_.displacement, node) - node_value(state_.unloaded, node))
                           .norm_square());
  return std::sqrt(Utilities::MPI::max(largest, body_.communicator()));
}

double Unloading::largest_displacement() const {
  double largest = 0.;
  for (unsigned node = 0; node < body_.n_owned_nodes(); ++node)
    largest = std::max(largest, node_value(state_.displacement, node).norm_square());
  return std::sqrt(Utilities::MPI::max(largest, body_.communicator()));
}

Unloading::State Unloading::state_with_velocity() const {
  State state = state_;
  state.velocity = integrator_.velocity();
  return state;
}

void Unloading::restore(const State& state) {
  state_ = state;
  state_.unloaded.update_ghost_values();
  state_.displacement.update_ghost_values();
  integrator_.velocity() = state.velocity;
  update_reference();
}

} // namespace prosup::unloading
