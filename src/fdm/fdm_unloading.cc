#include "prosup/fdm/fdm_unloading.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "prosup/core/error.h"
#include "simulation.h"

namespace prosup::fdm {

namespace {

constexpr unsigned blocks_per_update = 10; ///< of the time step and the good state
constexpr double smallest_healthy_jacobian = 0.01;
constexpr double ramp_in_lags = 4.;
constexpr double stiffest_background = 0.1; // over that of the softest tissue
// An error that has not halved in so many steps flutters.
constexpr unsigned steps_to_halve = 1000;

} // namespace

UnloadingResult FdmUnloading::Simulation::simulate(unsigned max_steps, bool until_settled) {
  UnloadingResult result;
  first_ = last_good_ = save();
  last_good_error_ = std::numeric_limits<double>::max();
  has_kept_ = false;
  unsigned n_blocks = 0, n_last_look = 0;
  double last_error = std::numeric_limits<double>::max();
  double smallest_error = last_error;
  while (result.n_steps < max_steps) {
    const unsigned n = std::min(parameters_.resampling_interval, max_steps - result.n_steps);
    const double duration = n * dynamics_.time_step();
    time_ += duration;
    const double ramp = caution_.gravity_ramp;
    loading_ += ramp > 0. ? duration * damping_ / ramp : 1.;
    fully_loaded_ = force_record_.update(time_, maps_) && loading_ >= 1.;
    resample();
    update_force();
    dynamics_.set_damping(damping_);
    const Report report = steps(n);
    result.n_steps += n;
    if (const std::string what = trouble(report); !what.empty()) {
      retreat(what, result);
      continue;
    }
    result.min_jacobian = report.min_jacobian;
    result.residual = report.residual;
    result.distance = report.distance;
    log_.progress(format("  %s: step %u, residual %.1e, max |w-u| %.3f mm, min J %.2f",
                         name_.c_str(), result.n_steps, result.residual, result.distance,
                         result.min_jacobian));
    const double error =
        std::max({report.residual / parameters_.residual_tolerance,
                  report.distance / parameters_.position_tolerance,
                  report.residual * report.max_displacement / parameters_.position_tolerance});
    result.converged = fully_loaded_ && error < 1.;
    if (result.converged && until_settled)
      break;
    smallest_error = std::min(smallest_error, error);
    if (until_settled && fully_loaded_ && result.n_steps >= n_last_look + steps_to_halve) {
      if (smallest_error > 0.5 * last_error) {
        strengthen();
        ++result.n_retries;
      }
      last_error = smallest_error;
      smallest_error = std::numeric_limits<double>::max();
      n_last_look = result.n_steps;
    }
    ++n_blocks;
    if (n_blocks % blocks_per_update == 0 && fully_loaded_ && error < last_good_error_) {
      last_good_ = save();
      last_good_error_ = error;
      has_kept_ = true;
    }
    if (!holds_reference_)
      follow();
    if (n_blocks % blocks_per_update == 0 || n_blocks == 1)
      update_time_step();
  }
  if (until_settled && !result.converged)
    result.explanation = format(
        "The unloading of %s by finite differences has not settled in %u steps (residual %.1e, "
        "max |w - u| %.3f mm); raise 'FDM/Maximum steps' or the tolerances.",
        name_.c_str(), result.n_steps, result.residual, result.distance);
  return result;
}

std::string FdmUnloading::Simulation::trouble(const Report& report) const {
  if (!std::isfinite(report.residual) || !std::isfinite(report.kinetic_energy))
    return "forces are not finite";
  if (!(report.min_jacobian > smallest_healthy_jacobian))
    return format("a cell collapsed to J = %.2g", report.min_jacobian);
  if (report.kinetic_energy > 1.)
    return "the body moves faster than in a free fall";
  return {};
}

void FdmUnloading::Simulation::retreat(const std::string& trouble, UnloadingResult& result) {
  if (result.n_retries >= parameters_.max_retries) {
    restore(last_good_);
    throw DivergenceError(format(
        "The unloading of %s by finite differences diverges after %u steps and %u retries: %s; "
        "raise 'FDM/Lag factor' or the stiffness, or check labels and gravity.",
        name_.c_str(), result.n_steps, result.n_retries, trouble.c_str()));
  }
  ++result.n_retries;
  // Most often it is the jump of stiffness at the skin that diverges.
  const bool has_stiffer_air = stiffen_background();
  if (!has_stiffer_air)
    strengthen();
  caution_.gravity_ramp = std::max(2. * caution_.gravity_ramp, ramp_in_lags * caution_.lag_factor);
  caution_.step_safety *= 0.8;
  // A good state from which it diverged twice was none.
  restore(has_kept_ ? last_good_ : first_);
  last_good_ = first_;
  last_good_error_ = std::numeric_limits<double>::max();
  has_kept_ = false;
  log_.line(format("  %s: %s after %u steps; goes on from a good state with smaller steps and %s.",
                   name_.c_str(), trouble.c_str(), result.n_steps,
                   has_stiffer_air ? "stiffer air" : "a longer lag"));
}

bool FdmUnloading::Simulation::stiffen_background() {
  double& stiffness = caution_.background_stiffness;
  if (stiffness >= stiffest_background)
    return false;
  stiffness = std::min(2. * stiffness, stiffest_background);
  maps_.set_material(material_, stiffness);
  return true;
}

void FdmUnloading::Simulation::strengthen() {
  // What flutters needs damping; more than this makes settling too slow. The lag is
  // measured in damping times.
  caution_.damping_factor = std::min(2. * caution_.damping_factor, 16.);
  if (parameters_.correction_scheme() == Correction::relaxed)
    caution_.lag_factor *= 2.;
}

State FdmUnloading::Simulation::save() const {
  return {dynamics_.displacement,
          dynamics_.increment,
          pull_back_,
          dynamics_.time_step(),
          time_,
          loading_};
}

void FdmUnloading::Simulation::restore(const State& state) {
  dynamics_.displacement = state.displacement;
  dynamics_.set_time_step(state.time_step);
  dynamics_.increment = state.increment;
  pull_back_ = state.pull_back;
  time_ = state.time;
  loading_ = state.loading;
  force_record_.update(time_, maps_);
  resample();
  update_time_step();
}

void FdmUnloading::Simulation::restore(const Snapshot& snapshot) {
  force_record_ = snapshot.force_record;
  force_record_.write_again();
  restore(snapshot.state);
}

FdmUnloading::FdmUnloading(const FdmParameters& parameters, const image::LabelImage& labels,
                           unsigned chest_label, const Material& material,
                           const dealii::Tensor<1, 3>& gravity, const ChestCondition& chest,
                           MPI_Comm communicator, std::string name, const Log& log)
    : simulation_(std::make_unique<Simulation>(parameters, labels, chest_label, material, gravity,
                                               chest, communicator, std::move(name), log)) {}

FdmUnloading::~FdmUnloading() = default;

void FdmUnloading::set_material(const Material& material) {
  simulation_->set_material(material);
}

void FdmUnloading::set_spring_stiffness(double stiffness) {
  simulation_->set_spring_stiffness(stiffness);
}

void FdmUnloading::add_force(const VectorField& force, double ramp_time) {
  simulation_->add_force(force, ramp_time);
}

void FdmUnloading::hold_reference() {
  simulation_->hold_reference();
}

UnloadingResult FdmUnloading::run() {
  return run(simulation_->max_steps());
}

UnloadingResult FdmUnloading::run(unsigned max_steps) {
  return simulation_->simulate(max_steps, true);
}

std::shared_ptr<const FdmUnloading::Snapshot> FdmUnloading::save() const {
  return std::make_shared<Snapshot>(simulation_->snapshot());
}

void FdmUnloading::restore(const Snapshot& snapshot) {
  simulation_->restore(snapshot);
}

UnloadingResult FdmUnloading::advance(unsigned n_steps) {
  return simulation_->simulate(n_steps, false);
}

const image::VoxelGrid& FdmUnloading::grid() const {
  return simulation_->slab().grid();
}

VectorField FdmUnloading::displacement() const {
  return simulation_->displacement();
}

double FdmUnloading::time_step() const {
  return simulation_->dynamics().time_step();
}

double FdmUnloading::damping_rate() const {
  return simulation_->damping_rate();
}

} // namespace prosup::fdm
