#include "simulation.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "prosup/core/error.h"

namespace prosup::fdm {

using namespace dealii;

namespace {

void check(const Material& material) {
  for (const auto& [label, lame] : material.tissues)
    if (!(lame.mu > 0.) || !(lame.lambda > 0.))
      throw Error(format("The tissue with label %u has mu = %g Pa and lambda = %g Pa; both have to "
                         "be positive.",
                         label, lame.mu, lame.lambda));
}

} // namespace

void FdmUnloading::Simulation::set_material(const Material& material) {
  check(material);
  material_ = material;
  maps_.set_material(material_, caution_.background_stiffness);
  force_record_.update(time_, maps_);
  resample();
  update_time_step();
}

void FdmUnloading::Simulation::update_time_step() {
  const double critical = Utilities::MPI::min(dynamics_.critical_time_step(), slab_.communicator());
  dynamics_.set_time_step(caution_.step_safety * critical);
  dynamics_.set_damping(damping_);
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
  const double gravity_part = std::min(1., loading_);
  for (unsigned c = 0; c < 3; ++c) {
    const Real g = Real(gravity_part * gravity_[c]);
    for (std::size_t node = slab_.owned_begin(); node < slab_.owned_end(); ++node)
      dynamics_.force[c][node] = g * tissue_[node] + extra_force_[c][node];
  }
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

void FdmUnloading::Simulation::add_force(const VectorField& force, double ramp_time) {
  force_record_.add(force, displacement(), time_, ramp_time, maps_);
}

void FdmUnloading::Simulation::follow() {
  const double lag = caution_.lag_factor / damping_;
  const double beta =
      parameters_.correction_scheme() == Correction::full
          ? 1.
          : std::min(1., parameters_.resampling_interval * dynamics_.time_step() / lag);
  for (unsigned c = 0; c < 3; ++c)
    for (std::size_t node = 0; node < slab_.n_nodes(); ++node)
      pull_back_[c][node] += Real(beta) * (dynamics_.displacement[c][node] - pull_back_[c][node]);
}

Report FdmUnloading::Simulation::steps(unsigned n) {
  double min_jacobian = std::numeric_limits<double>::max();
  Report result;
  for (unsigned i = 0; i < n; ++i) {
    const bool is_last = i + 1 == n;
    Dynamics::Vectors before;
    if (is_last)
      before = dynamics_.increment;
    min_jacobian = std::min(min_jacobian, dynamics_.advance_increments());
    if (is_last)
      result = report(before, min_jacobian);
    chest_.correct(dynamics_);
    dynamics_.move();
    wall_->lead(dynamics_);
  }
  return result;
}

Report FdmUnloading::Simulation::report(const Dynamics::Vectors& before, double min_jacobian) {
  enum { residual, weight, work, inertia, kinetic, volume, n_sums };
  double sums[n_sums] = {}, distance = 0., displacement = 0.;
  for (std::size_t node = slab_.owned_begin(); node < slab_.owned_end(); ++node) {
    if (!dynamics_.is_mobile(node))
      continue;
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
      continue;
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
  Utilities::MPI::sum(ArrayView<const double>(sums, n_sums), slab_.communicator(),
                      ArrayView<double>(sums, n_sums));
  if (parameters_.damping == 0. && sums[work] > 0. && sums[inertia] > 0.) {
    // A body that has hardly moved yet seems to have no frequency.
    damping_ =
        caution_.damping_factor * std::max(first_damping_, std::sqrt(sums[work] / sums[inertia]));
  }
  const double h_t = dynamics_.time_step();
  Report result;
  result.min_jacobian = Utilities::MPI::min(min_jacobian, slab_.communicator());
  result.residual = std::sqrt(sums[residual] / (sums[weight] > 0. ? sums[weight] : 1.));
  result.distance =
      holds_reference_ ? 0. : std::sqrt(Utilities::MPI::max(distance, slab_.communicator()));
  result.max_displacement = std::sqrt(Utilities::MPI::max(displacement, slab_.communicator()));
  result.kinetic_energy = head_ > 0. ? sums[kinetic] / (h_t * h_t * sums[volume] * head_) : 0.;
  return result;
}

} // namespace prosup::fdm
