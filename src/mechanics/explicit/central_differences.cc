#include "prosup/mechanics/explicit/central_differences.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

#include "prosup/core/collective.h"

namespace prosup::mechanics {

using namespace dealii;

namespace {

/// The value below which the given fraction of all ranks' values lies, and
/// the smallest one.
double global_quantile(const std::vector<double>& values, double fraction, MPI_Comm communicator) {
  std::vector<double> all = all_gathered(values, communicator);
  const auto nth = static_cast<std::size_t>(fraction * static_cast<double>(all.size() - 1));
  std::nth_element(all.begin(), all.begin() + nth, all.end());
  return all[nth];
}

/// max_a k_a / m_a of springs to the ground, 1/s^2: what they can add to the
/// highest squared frequency (Weyl). Collective.
double largest_ratio(const std::vector<double>& springs, const std::vector<double>& mass,
                     const Body& body) {
  double largest = 0.;
  for (unsigned node = 0; node < springs.size(); ++node)
    largest = std::max(largest, springs[node] / mass[node]);
  return Utilities::MPI::max(largest, body.communicator());
}

} // namespace

StableMass stable_mass(const Supports& supports, const InternalForce& internal_force,
                       HighestFrequency& highest_frequency, const NodeVector& displacement,
                       double density, double scaled_fraction) {
  const Body& body = supports.body();
  StableMass result;
  result.mass = internal_force.lumped_volume();
  for (double& mass : result.mass)
    mass *= density;
  std::vector<double> stiffness = internal_force.stiffness_bound(displacement);
  const std::vector<double>& springs = supports.spring_stiffness();
  for (unsigned node = 0; node < springs.size(); ++node)
    stiffness[node] += springs[node];
  std::vector<double> critical(body.n_owned_nodes());
  for (unsigned node = 0; node < critical.size(); ++node)
    critical[node] = 2. * std::sqrt(result.mass[node] / stiffness[node]);
  const bool is_finite = std::all_of(critical.begin(), critical.end(),
                                     [](double step) { return std::isfinite(step); });
  if (Utilities::MPI::min(static_cast<int>(is_finite), body.communicator()) == 0)
    return result;
  const double wanted = global_quantile(critical, scaled_fraction, body.communicator());

  unsigned n_scaled = 0;
  for (unsigned node = 0; node < result.mass.size(); ++node) {
    const double needed = stiffness[node] * 0.25 * wanted * wanted;
    if (result.mass[node] < needed) {
      result.mass[node] = needed;
      n_scaled += node < body.n_owned_nodes();
    }
  }
  result.scaled_fraction = static_cast<double>(Utilities::MPI::sum(n_scaled, body.communicator())) /
                           n_global_nodes(body);
  result.critical_step = highest_frequency.estimate(displacement, result.mass, supports.fixed())
                             .critical_step(largest_ratio(springs, result.mass, body));
  return result;
}

CentralDifferences::CentralDifferences(const Supports& supports,
                                       const InternalForce& internal_force)
    : body_(supports.body()), supports_(supports), internal_force_(internal_force) {
  update_fixed();
  body_.initialize(force_);
  body_.initialize(velocity_);
}

void CentralDifferences::update_fixed() {
  mobility_.clear();
  for (unsigned node = 0; node < body_.n_owned_nodes(); ++node)
    mobility_.push_back(supports_.fixed()[node] ? 0. : 1.);
}

void CentralDifferences::set_mass(const StableMass& mass, double safety) {
  mass_ = mass.mass;
  time_step_ = safety * mass.critical_step;
}

double CentralDifferences::step(const NodeVector& external_force, NodeVector& displacement) {
  std::copy_n(external_force.begin(), 3 * body_.n_owned_nodes(), force_.begin());
  min_jacobian_ = internal_force_.subtract(displacement, force_);
  const double h = time_step_;
  supports_.add_spring_forces(displacement, force_);
  supports_.contacts().add_correction_forces(displacement, velocity_, mass_, h, force_);

  const double decay = 1. / (1. + h * damping_rate_);
  double* v = velocity_.begin();
  double* u = displacement.begin();
  double* f = force_.begin();
  for (unsigned node = 0; node < body_.n_owned_nodes(); ++node) {
    const double gain = decay * h * mobility_[node] / mass_[node];
    for (unsigned c = 0; c < 3; ++c, ++v, ++u, ++f) {
      *f *= mobility_[node];
      *v = decay * mobility_[node] * *v + gain * *f;
      *u += h * *v;
    }
  }
  supports_.contacts().constrain(displacement, velocity_, force_);
  return min_jacobian_;
}

StepReport CentralDifferences::report() const {
  double sums[2] = {0., 0.};
  for (unsigned node = 0; node < body_.n_owned_nodes(); ++node) {
    sums[0] += 0.5 * mass_[node] * node_value(velocity_, node).norm_square();
    sums[1] += node_value(force_, node).norm_square();
  }
  Utilities::MPI::sum(ArrayView<const double>(sums, 2), body_.communicator(),
                      ArrayView<double>(sums, 2));
  return {Utilities::MPI::min(min_jacobian_, body_.communicator()), sums[0], std::sqrt(sums[1])};
}

} // namespace prosup::mechanics
