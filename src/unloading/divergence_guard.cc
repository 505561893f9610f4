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

// An error that falls by less than this part in a window of this many lag times and
// steps does not fall. Slow modes of nearly incompressible tissue need some patience.
constexpr double least_progress = 0.2;
constexpr double window_in_lags = 20.;
constexpr unsigned window_in_steps = 300;

} // namespace

DivergenceGuard::DivergenceGuard(const UnloadingParameters& parameters, const mechanics::Body& body,
                                 const Tensor<1, 3>& gravity)
    : parameters_(parameters),
      body_(body), values_{parameters.lag_factor, parameters.step_safety, parameters.gravity_ramp},
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

void DivergenceGuard::set_material(const std::vector<mechanics::LameParameters>& material) {
  double sums[2] = {0., static_cast<double>(body_.n_elements())};
  for (unsigned e = 0; e < body_.n_elements(); ++e)
    sums[0] += material[material.size() == 1 ? 0 : e].mu;
  Utilities::MPI::sum(ArrayView<const double>(sums, 2), body_.communicator(),
                      ArrayView<double>(sums, 2));
  mean_shear_modulus_ = sums[0] / sums[1];
}

void DivergenceGuard::begin(Unloading::State state) {
  first_ = last_good_ = std::move(state);
  n_retries_ = 0;
  has_kept_ = true;
  smallest_error_ = 0.;
}

void DivergenceGuard::keep(Unloading::State state) {
  last_good_ = std::move(state);
  has_kept_ = true;
}

std::string DivergenceGuard::trouble(const mechanics::StepReport& report,
                                     double reference_volume) const {
  if (!std::isfinite(report.residual_norm) || !std::isfinite(report.kinetic_energy))
    return "forces are not finite";
  if (!(reference_volume > 0.))
    return "an element of the unloaded configuration is inverted";
  if (!(report.min_jacobian > smallest_healthy_jacobian))
    return "an element collapsed";
  if (parameters_.gravity > 0. && report.kinetic_energy > kinetic_energy_limit_)
    return "the body moves faster than in a free fall";
  return {};
}

std::string DivergenceGuard::worst_cell(const mechanics::InternalForce& internal_force,
                                        const NodeVector& displacement) const {
  const auto mine = internal_force.worst_cell(body_.vertex_positions(), displacement);
  const std::string text = format("cell %u near (%.1f, %.1f, %.1f) mm has J = %.2g", mine.cell,
                                  mine.centre[0], mine.centre[1], mine.centre[2], mine.jacobian);
  const auto jacobians = Utilities::MPI::all_gather(body_.communicator(), mine.jacobian);
  const auto texts = Utilities::MPI::all_gather(body_.communicator(), text);
  const auto worst = std::min_element(jacobians.begin(), jacobians.end());
  return *worst < std::numeric_limits<double>::max() ? texts[worst - jacobians.begin()] : "";
}

bool DivergenceGuard::is_stalled(double error, double elapsed, unsigned n_steps) {
  if (smallest_error_ == 0. || elapsed < window_start_) { // the first of a window
    smallest_error_ = error;
    smallest_before_ = std::numeric_limits<double>::max();
    window_start_ = elapsed;
    window_first_step_ = n_steps;
    return false;
  }
  smallest_error_ = std::min(smallest_error_, error);
  if (elapsed < window_start_ + window_in_lags * std::max(1., values_.lag_factor) ||
      n_steps < window_first_step_ + window_in_steps)
    return false;
  const bool result = smallest_error_ > (1. - least_progress) * smallest_before_;
  smallest_before_ = std::min(smallest_before_, smallest_error_);
  smallest_error_ = error;
  window_start_ = elapsed;
  window_first_step_ = n_steps;
  return result;
}

const Unloading::State& DivergenceGuard::retreat(double correction_lag, bool is_stalled) {
  ++n_retries_;
  values_.lag_factor = 2. * std::max(values_.lag_factor, correction_lag);
  values_.step_safety *= is_stalled ? 1. : 0.8;
  if (!has_kept_) {
    last_good_ = first_;
    values_.gravity_ramp *= 2.;
  }
  has_kept_ = false;
  smallest_error_ = 0.;
  return last_good_;
}

void DivergenceGuard::be_careful() {
  values_ = {4. * std::max(1., parameters_.lag_factor), 0.8 * std::min(1., parameters_.step_safety),
             std::max(1., parameters_.gravity_ramp)};
  max_retries_ = std::min(2u, parameters_.max_retries);
}

std::string DivergenceGuard::softness() const {
  return format("rho g L/mu = %.2g", parameters_.density * largest_head_ / mean_shear_modulus_);
}

} // namespace prosup::unloading
