#include "prosup/unloading/unloading.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "prosup/core/error.h"

namespace prosup::unloading {

using namespace dealii;
using mechanics::node_value;

namespace {

// The mass follows the deformation (smaller cells, stiffer tangent) in
// intervals: its bound costs as much as a few steps.
constexpr unsigned corrections_per_mass_update = 20;
constexpr unsigned corrections_per_snapshot = 10;
constexpr double smallest_healthy_jacobian = 0.02;

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
      lag_factor_(parameters.lag_factor), safety_(parameters.step_safety) {
  if (!supports.hold_anything())
    throw Error("Nothing holds " + name_ +
                ": its mesh has neither a chest wall nor cut planes, or both are set free; check "
                "the labels, 'Meshing/Chest label' and 'Supports/Cut planes'.");
  for (NodeVector* vector : {&state_.unloaded, &state_.displacement, &state_.velocity,
                             &state_.force, &state_.force_increment, &external_force_})
    body_.initialize(*vector);
  state_.unloaded = body_.vertex_positions();
  state_.unloaded.update_ghost_values();
  state_.displacement.update_ghost_values();
  integrator_.set_damping(parameters.damping_rate);
}

void Unloading::set_material(const std::vector<mechanics::LameParameters>& parameters) {
  internal_force_.set_material(parameters);
  update_reference();
  update_mass();
}

void Unloading::add_force(const NodeVector& increment, double ramp_time) {
  state_.force += state_.force_increment;
  std::copy_n(increment.begin(), 3 * body_.n_owned_nodes(), state_.force_increment.begin());
  state_.ramp_start = state_.time;
  state_.ramp_time = ramp_time;
}

UnloadingResult Unloading::run() {
  return simulate(parameters_.max_steps, true);
}

UnloadingResult Unloading::advance(unsigned n_steps) {
  return simulate(n_steps, false);
}

UnloadingResult Unloading::simulate(unsigned max_steps, bool until_settled) {
  UnloadingResult result;
  last_good_ = save();
  unsigned n_corrections = 0;
  while (result.n_steps < max_steps) {
    const unsigned n = std::min(parameters_.correction_interval, max_steps - result.n_steps);
    const double duration = n * integrator_.time_step();
    state_.time += duration;
    state_.loading += duration * damping_.time_scale();
    update_external_force();
    supports_.linearize(state_.unloaded, state_.displacement);
    min_jacobian_ = std::numeric_limits<double>::max();
    for (unsigned i = 0; i < n; ++i) {
      min_jacobian_ =
          std::min(min_jacobian_, integrator_.step(external_force_, state_.displacement));
      if (damping_.watches_every_step() || i + 1 == n)
        damping_.update(integrator_, state_.displacement, external_force_);
    }
    result.n_steps += n;

    mechanics::StepReport report = integrator_.report();
    report.min_jacobian = Utilities::MPI::min(min_jacobian_, body_.communicator());
    if (!is_healthy(report)) {
      retreat(report, result);
      continue;
    }
    result.min_jacobian = report.min_jacobian;
    result.residual = report.residual_norm / weight_norm_;
    result.distance = holds_reference_ ? 0. : max_distance();
    log_.progress(format("  %s: step %u, residual %.1e, max |x-u-X| %.3f mm, min J %.2f",
                         name_.c_str(), result.n_steps, result.residual, result.distance,
                         result.min_jacobian));
    result.converged = result.residual < parameters_.residual_tolerance &&
                       result.distance < parameters_.position_tolerance && fully_loaded_;
    if ((result.converged && until_settled) || (observer_ && !observer_(result.n_steps)))
      break;
    if (++n_corrections % corrections_per_snapshot == 0)
      last_good_ = save();
    if (!holds_reference_)
      correct_unloaded_positions();
    if (n_corrections % corrections_per_mass_update == 0)
      update_mass();
  }
  return result;
}

void Unloading::correct_unloaded_positions() {
  const double lag = lag_factor_ / damping_.time_scale();
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
  supports_.put_on_surfaces(state_.unloaded);
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
  integrator_.set_mass(mechanics::stable_mass(supports_, internal_force_, highest_frequency_,
                                              state_.displacement, parameters_.density,
                                              parameters_.scaled_fraction),
                       safety_);
  // All of the body faster than it would be after falling freely through its
  // own size is no settling motion.
  double lower = std::numeric_limits<double>::max(), upper = -lower, mass = 0.;
  for (unsigned node = 0; node < body_.n_owned_nodes(); ++node) {
    const double height = node_value(body_.vertex_positions(), node) * gravity_;
    lower = std::min(lower, height);
    upper = std::max(upper, height);
    mass += parameters_.density * nodal_volume_[node];
  }
  const MPI_Comm communicator = body_.communicator();
  kinetic_energy_limit_ =
      Utilities::MPI::sum(mass, communicator) *
      (Utilities::MPI::max(upper, communicator) - Utilities::MPI::min(lower, communicator));
}

void Unloading::update_external_force() {
  const double gravity_part =
      parameters_.gravity_ramp > 0. ? std::min(1., state_.loading / parameters_.gravity_ramp) : 1.;
  const double since = state_.time - state_.ramp_start;
  const double increment_part = state_.ramp_time > 0. ? std::min(1., since / state_.ramp_time) : 1.;
  fully_loaded_ = gravity_part == 1. && increment_part == 1.;
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

bool Unloading::is_healthy(const mechanics::StepReport& report) const {
  return report.min_jacobian > smallest_healthy_jacobian && reference_volume_ > 0. &&
         std::isfinite(report.residual_norm) && std::isfinite(report.kinetic_energy) &&
         (parameters_.gravity <= 0. || report.kinetic_energy <= kinetic_energy_limit_);
}

void Unloading::retreat(const mechanics::StepReport& report, UnloadingResult& result) {
  const std::string reason = diagnosis(report);
  const bool is_full =
      !holds_reference_ && parameters_.correction_scheme() == CorrectionScheme::full;
  restore(last_good_);
  state_.velocity = 0.;
  integrator_.velocity() = 0.;
  if (result.n_retries >= parameters_.max_retries)
    throw DivergenceError(
        "The unloading of " + name_ + " diverged at step " + std::to_string(result.n_steps) + " (" +
        reason + ") and " + std::to_string(result.n_retries) + " retries with " +
        (is_full
             ? "smaller steps did not help; the full correction flutters on soft bodies, so "
               "choose 'Unloading/Correction' = relaxed, or raise 'Unloading/Damping rate' with "
               "'Unloading/Damping' = fixed."
             : "longer lags and smaller steps did not help; the body may be too soft for "
               "its weight, so raise 'Material/Shear modulus' or check the mask and mesh "
               "there."));
  ++result.n_retries;
  if (!is_full) // who asks for the paper's scheme gets it to the end
    lag_factor_ = 2. * std::max(lag_factor_, parameters_.correction_interval *
                                                 integrator_.time_step() * damping_.time_scale());
  safety_ *= 0.8;
  update_mass();
  log_.line(format("  %s: %s; back to the last good state, %s, time step %.2f ms", name_.c_str(),
                   reason.c_str(),
                   is_full ? "full correction" : format("lag factor %.1f", lag_factor_).c_str(),
                   1e3 * integrator_.time_step()));
}

std::string Unloading::diagnosis(const mechanics::StepReport& report) const {
  if (!std::isfinite(report.residual_norm) || !std::isfinite(report.kinetic_energy))
    return "forces are not finite";
  if (!(reference_volume_ > 0.))
    return "an element of the unloaded configuration is inverted";
  if (report.min_jacobian > smallest_healthy_jacobian)
    return format("the kinetic energy grew to %.2g g mm^2/s^2", report.kinetic_energy);
  const std::string mine = internal_force_.describe_worst_cell(state_.unloaded, state_.displacement,
                                                               smallest_healthy_jacobian);
  for (const std::string& cell : Utilities::MPI::all_gather(body_.communicator(), mine))
    if (!cell.empty())
      return cell + " collapsed";
  return format("an element collapsed to J = %.2g", report.min_jacobian);
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
