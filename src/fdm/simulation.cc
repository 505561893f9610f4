#include "simulation.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace prosup::fdm {

using namespace dealii;

settling::Report FdmUnloading::Simulation::advance(unsigned n_steps, double gravity_ramp) {
  const double duration = n_steps * dynamics_.time_step();
  time_ += duration;
  loading_ += gravity_ramp > 0. ? duration * damping_ / gravity_ramp : 1.;
  is_fully_loaded_ = force_record_.update(time_, maps_) && loading_ >= 1.;
  resample();
  update_force();
  dynamics_.set_damping(damping_);
  min_jacobian_ = std::numeric_limits<double>::max();
  settling::Report result;
  for (unsigned i = 0; i < n_steps; ++i) {
    const bool is_last = i + 1 == n_steps;
    Dynamics::Vectors before;
    if (is_last)
      before = dynamics_.increment;
    min_jacobian_ = std::min(min_jacobian_, dynamics_.advance_increments());
    if (is_last)
      result = report(before);
    chest_.correct(dynamics_);
    dynamics_.move();
    wall_->lead(dynamics_);
  }
  return result;
}

void FdmUnloading::Simulation::resample() {
  for (std::size_t node = 0; node < slab_.n_nodes(); ++node) {
    if (!is_near_mobile_[node])
      continue;
    Point<3> x = slab_.position(node);
    for (unsigned c = 0; c < 3; ++c)
      x[c] += pull_back_[c][node];
    const LoadedMaps::Values values = maps_.values(x);
    dynamics_.mu[node] = values.mu;
    dynamics_.lambda[node] = values.lambda;
    tissue_[node] = values.tissue;
    for (unsigned c = 0; c < 3; ++c)
      extra_force_[c][node] = Real(values.force[c] / density_);
  }
}

void FdmUnloading::Simulation::update_force() {
  const double gravity_part =
      gravity_from_ + (gravity_to_ - gravity_from_) * std::min(1., loading_);
  for (unsigned c = 0; c < 3; ++c) {
    const Real g = Real(gravity_part * gravity_[c]);
    for (std::size_t node = slab_.owned_begin(); node < slab_.owned_end(); ++node)
      dynamics_.force[c][node] = g * tissue_[node] + extra_force_[c][node];
  }
}

void FdmUnloading::Simulation::correct(double part) {
  for (unsigned c = 0; c < 3; ++c)
    for (std::size_t node = 0; node < slab_.n_nodes(); ++node)
      pull_back_[c][node] += Real(part) * (dynamics_.displacement[c][node] - pull_back_[c][node]);
}

void FdmUnloading::Simulation::update_time_step(double safety) {
  const double critical = Utilities::MPI::min(dynamics_.critical_time_step(), slab_.communicator());
  dynamics_.set_time_step(safety * critical);
  dynamics_.set_damping(damping_);
}

void FdmUnloading::Simulation::add_to_sums(std::size_t node, const Dynamics::Vectors& before,
                                           double* sums, double& distance,
                                           double& displacement) const {
  Tensor<1, 3> K = dynamics_.acceleration(before, node);
  const double part = tissue_[node];
  double u_squared = 0., lag_squared = 0., v_squared = 0.;
  for (unsigned c = 0; c < 3; ++c) {
    const double u = dynamics_.displacement[c][node];
    sums[work] += u * (dynamics_.force[c][node] - K[c]);
    u_squared += u * u;
    lag_squared += (u - pull_back_[c][node]) * (u - pull_back_[c][node]);
    v_squared += double(dynamics_.increment[c][node]) * dynamics_.increment[c][node];
  }
  sums[inertia] += u_squared;
  if (!(part > 0.))
    return;
  chest_.project(dynamics_, node, K);
  sums[residual] += part * K.norm_square();
  sums[weight] += part * part * part * gravity_.norm_square();
  sums[kinetic] += 0.5 * part * v_squared;
  sums[volume] += part;
  if (part > 0.5) {
    distance = std::max(distance, lag_squared);
    displacement = std::max(displacement, u_squared);
  }
}

/// `before` are the increments of the step before.
settling::Report FdmUnloading::Simulation::report(const Dynamics::Vectors& before) {
  double sums[n_sums] = {}, distance = 0., displacement = 0.;
  for (std::size_t node = slab_.owned_begin(); node < slab_.owned_end(); ++node)
    if (dynamics_.is_mobile(node))
      add_to_sums(node, before, sums, distance, displacement);
  const MPI_Comm communicator = slab_.communicator();
  Utilities::MPI::sum(ArrayView<const double>(sums, n_sums), communicator,
                      ArrayView<double>(sums, n_sums));
  follow_lowest_frequency(sums[work], sums[inertia]);
  largest_displacement_ = std::sqrt(Utilities::MPI::max(displacement, communicator));
  const double h_t = dynamics_.time_step();
  settling::Report result;
  result.min_jacobian = Utilities::MPI::min(min_jacobian_, communicator);
  result.residual = std::sqrt(sums[residual] / (sums[weight] > 0. ? sums[weight] : 1.));
  result.distance = holds_reference_ ? 0. : std::sqrt(Utilities::MPI::max(distance, communicator));
  result.kinetic_energy = head_ > 0. ? sums[kinetic] / (h_t * h_t * sums[volume] * head_) : 0.;
  result.is_fully_loaded = is_fully_loaded_;
  return result;
}

/// omega^2 = u.(f - K) / u.u, unless r/rho is given.
void FdmUnloading::Simulation::follow_lowest_frequency(double work_sum, double inertia_sum) {
  if (parameters_.damping_rate > 0. || !(work_sum > 0.) || !(inertia_sum > 0.))
    return;
  // A body that has hardly moved yet seems to have a frequency near zero.
  damping_ = damping_factor_ * std::max(first_damping_, std::sqrt(work_sum / inertia_sum));
}

VectorField FdmUnloading::Simulation::displacement() const {
  VectorField result{slab_.grid(), std::vector<Tensor<1, 3>>(slab_.grid().n_voxels())};
  for (unsigned c = 0; c < 3; ++c) {
    const NodalField component = slab_.gather(dynamics_.displacement[c]);
    for (std::size_t node = 0; node < component.size(); ++node)
      result.values[node][c] = component[node];
  }
  return result;
}

} // namespace prosup::fdm
