#include "divergence_guard.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "prosup/core/log.h"

namespace prosup::unloading {

using namespace dealii;
using mechanics::node_value;

namespace {

constexpr double smallest_healthy_jacobian = 0.02;

// The mass follows the deformation (smaller cells, stiffer tangent) in intervals: its
// bound costs as much as a few steps.
constexpr unsigned corrections_per_mass_update = 20;

// An error that falls by less than this part in a window of this many lag times and
// steps does not fall. Slow modes of nearly incompressible tissue need some patience.
constexpr double least_progress = 0.2;
constexpr double window_in_lags = 10.;
constexpr unsigned window_in_steps = 300;

constexpr double ramp_in_lags = 4.;

// A body that needed a retry has soft modes: a small |x - u - X| is then a larger
// distance of X.
constexpr double tolerance_after_retreat = 0.25;

std::string describe(const mechanics::InternalForce::WorstCell& worst, double jacobian) {
  return format("cell %u near (%.1f, %.1f, %.1f) mm with J = %.2g", worst.cell, worst.centre[0],
                worst.centre[1], worst.centre[2], jacobian);
}

} // namespace

DivergenceGuard::DivergenceGuard(const UnloadingParameters& parameters, const mechanics::Body& body,
                                 const Tensor<1, 3>& gravity)
    : parameters_(parameters),
      body_(body), values_{parameters.lag_factor, parameters.step_safety, parameters.gravity_ramp,
                           corrections_per_mass_update, 1.},
      max_retries_(parameters.max_retries) {
  double lower = std::numeric_limits<double>::max(), upper = -lower;
  for (unsigned node = 0; node < body.n_owned_nodes(); ++node) {
    const double head = node_value(body.vertex_positions(), node) * gravity;
    lower = std::min(lower, head);
    upper = std::max(upper, head);
  }
  largest_head_ = Utilities::MPI::max(upper, body.communicator()) -
                  Utilities::MPI::min(lower, body.communicator());
}

void DivergenceGuard::set_material(const mechanics::Material& material) {
  double sums[2] = {0., static_cast<double>(body_.n_elements())};
  for (unsigned e = 0; e < body_.n_elements(); ++e)
    sums[0] += material[e].mu;
  Utilities::MPI::sum(ArrayView<const double>(sums, 2), body_.communicator(),
                      ArrayView<double>(sums, 2));
  mean_shear_modulus_ = sums[0] / sums[1];
}

void DivergenceGuard::begin(Unloading::State state) {
  first_ = last_good_ = std::move(state);
  values_at_begin_ = values_;
  last_good_error_ = std::numeric_limits<double>::max();
  n_retries_ = 0;
  has_kept_ = false;
  smallest_error_ = 0.;
  forget_steps();
}

void DivergenceGuard::keep(Unloading::State state, double error) {
  last_good_ = std::move(state);
  last_good_error_ = error;
  has_kept_ = true;
}

void DivergenceGuard::forget_steps() {
  n_watched_ = 0;
  collapsed_cell_.clear();
}

void DivergenceGuard::watch_step(double min_jacobian,
                                 const mechanics::InternalForce& internal_force,
                                 const NodeVector& displacement) {
  ++n_watched_;
  if (min_jacobian > smallest_healthy_jacobian || !collapsed_cell_.empty())
    return;
  first_collapse_ = n_watched_;
  collapsed_cell_ =
      describe(internal_force.worst_cell(body_.vertex_positions(), displacement), min_jacobian);
}

std::string DivergenceGuard::trouble(const mechanics::StepReport& report,
                                     double reference_volume) const {
  if (!(reference_volume > 0.))
    return "an element of the unloaded configuration is inverted";
  if (!(report.min_jacobian > smallest_healthy_jacobian))
    return "an element collapsed";
  if (!std::isfinite(report.residual_norm) || !std::isfinite(report.kinetic_energy))
    return "forces are not finite";
  if (parameters_.gravity > 0. && report.kinetic_energy > kinetic_energy_limit_)
    return "the body moves faster than in a free fall";
  return {};
}

std::string DivergenceGuard::worst_cell(const mechanics::InternalForce& internal_force,
                                        const NodeVector& displacement) const {
  constexpr double never = std::numeric_limits<double>::max();
  const MPI_Comm communicator = body_.communicator();
  const auto worst_of_ranks = [&](double order, const std::string& text) -> std::string {
    const auto orders = Utilities::MPI::all_gather(communicator, order);
    const auto texts = Utilities::MPI::all_gather(communicator, text);
    const auto first = std::min_element(orders.begin(), orders.end());
    return *first < never ? texts[first - orders.begin()] : "";
  };
  const std::string collapsed =
      worst_of_ranks(collapsed_cell_.empty() ? never : first_collapse_, collapsed_cell_);
  if (!collapsed.empty())
    return collapsed;
  const auto worst = internal_force.worst_cell(body_.vertex_positions(), displacement);
  return worst_of_ranks(worst.jacobian, describe(worst, worst.jacobian));
}

bool DivergenceGuard::is_stalled(double error, double duration, unsigned n_steps) {
  if (smallest_error_ == 0.) { // the first look
    smallest_error_ = error;
    smallest_before_ = std::numeric_limits<double>::max();
    window_ = 0.;
    window_first_step_ = n_steps;
  }
  smallest_error_ = std::min(smallest_error_, error);
  window_ += duration;
  if (window_ < window_in_lags * std::max(1., values_.lag_factor) ||
      n_steps < window_first_step_ + window_in_steps)
    return false;
  const bool result = smallest_error_ > (1. - least_progress) * smallest_before_;
  smallest_before_ = std::min(smallest_before_, smallest_error_);
  smallest_error_ = error;
  window_ = 0.;
  window_first_step_ = n_steps;
  return result;
}

const Unloading::State& DivergenceGuard::retreat(double correction_lag, bool is_stalled) {
  ++n_retries_;
  if (parameters_.correction_scheme() == CorrectionScheme::relaxed)
    values_.lag_factor = 2. * std::max(values_.lag_factor, correction_lag);
  // A load that rises faster than the unloaded positions follow acts on a body that
  // hangs already.
  values_.gravity_ramp = std::max(2. * values_.gravity_ramp, ramp_in_lags * values_.lag_factor);
  values_.tolerance = tolerance_after_retreat;
  if (!is_stalled) {
    values_.step_safety *= 0.8;
    values_.mass_interval = std::max(1u, values_.mass_interval / 2);
    if (!has_kept_)
      last_good_ = first_;
  }
  last_good_error_ = std::numeric_limits<double>::max();
  has_kept_ = false;
  smallest_error_ = 0.;
  forget_steps();
  return last_good_;
}

void DivergenceGuard::be_careful() {
  const double lag = 4. * std::max(1., parameters_.lag_factor);
  values_ = {lag, 0.8 * std::min(1., parameters_.step_safety), 2. * lag,
             corrections_per_mass_update / 4, 1.};
  max_retries_ = std::min(3u, parameters_.max_retries);
}

std::string DivergenceGuard::softness() const {
  return format("rho g L/mu = %.2g", parameters_.density * largest_head_ / mean_shear_modulus_);
}

} // namespace prosup::unloading
