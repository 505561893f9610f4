// Construction of the simulation, its material and its added forces.

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <limits>

#include "prosup/core/error.h"
#include "simulation.h"

namespace prosup::unloading {

using namespace dealii;
using mechanics::node_value;

namespace {

// The mass has to follow the deformation, which makes cells smaller and stiffer. Its bound
// costs as much as a few steps.
constexpr unsigned corrections_per_mass_update = 20;

Tensor<1, 3> gravity_vector(const UnloadingParameters& parameters, const Tensor<1, 3>& direction) {
  if (!(direction.norm() > 0.))
    throw Error("The direction of gravity is (0, 0, 0); give a direction in LPS such as 0,-1,0 for "
                "prone and 0,1,0 for supine.");
  return parameters.gravity * direction / direction.norm();
}

/// |g| times the extent of the body along it.
double largest_head(const mechanics::Body& body, const Tensor<1, 3>& gravity) {
  double lower = std::numeric_limits<double>::max(), upper = -lower;
  for (unsigned node = 0; node < body.n_owned_nodes(); ++node) {
    const double head = node_value(body.vertex_positions(), node) * gravity;
    lower = std::min(lower, head);
    upper = std::max(upper, head);
  }
  return Utilities::MPI::max(upper, body.communicator()) -
         Utilities::MPI::min(lower, body.communicator());
}

double mean_shear_modulus(const mechanics::Body& body, const mechanics::Material& material) {
  double sums[2] = {0., static_cast<double>(body.n_elements())};
  for (unsigned e = 0; e < body.n_elements(); ++e)
    sums[0] += material[e].mu;
  Utilities::MPI::sum(ArrayView<const double>(sums, 2), body.communicator(),
                      ArrayView<double>(sums, 2));
  return sums[0] / sums[1];
}

} // namespace

Unloading::Simulation::Simulation(const UnloadingParameters& parameters,
                                  mechanics::Supports& supports,
                                  const Tensor<1, 3>& gravity_direction, const std::string& name,
                                  const Log& log)
    : parameters_(parameters), supports_(supports), body_(supports.body()),
      gravity_(gravity_vector(parameters, gravity_direction)), name_(name), internal_force_(body_),
      highest_frequency_(body_, internal_force_), integrator_(supports, internal_force_),
      damping_(parameters.damping_scheme(), parameters.damping_rate, body_),
      collapse_watch_(body_, internal_force_), largest_head_(largest_head(body_, gravity_)),
      loop_(*this, parameters,
            {name, "Unloading", "an element", "max |x-u-X|", corrections_per_mass_update}, log) {
  check();
  for (NodeVector* vector : {&state_.unloaded, &state_.displacement, &state_.velocity,
                             &state_.force, &state_.force_increment, &external_force_})
    body_.initialize(*vector);
  state_.unloaded = body_.vertex_positions();
  state_.unloaded.update_ghost_values();
  state_.displacement.update_ghost_values();
  integrator_.set_damping(parameters.damping_rate);
}

void Unloading::Simulation::check() const {
  if (!(parameters_.damping_rate > 0.))
    throw Error(format("'Unloading/Damping rate' is %g; it has to be positive, as ramp and lag are "
                       "measured in it and nothing settles without damping.",
                       parameters_.damping_rate));
  if (!supports_.hold_anything())
    throw Error("Nothing holds " + name_ +
                ": its mesh has neither a chest wall nor cut planes, or both are set free; check "
                "the labels, 'Labels/Chest' and 'Supports/Cut planes'.");
}

void Unloading::Simulation::set_material(const mechanics::Material& material) {
  mean_shear_modulus_ = mean_shear_modulus(body_, material);
  internal_force_.set_material(material);
  update_reference();
  update_time_step(loop_.caution().step_safety);
}

void Unloading::Simulation::set_gravity_direction(const Tensor<1, 3>& direction) {
  gravity_ = gravity_vector(parameters_, direction);
}

void Unloading::Simulation::add_force(const NodeVector& increment, double ramp_time) {
  state_.force += state_.force_increment;
  std::copy_n(increment.begin(), 3 * body_.n_owned_nodes(), state_.force_increment.begin());
  state_.ramp_start = state_.time;
  state_.ramp_time = ramp_time;
}

/// x - X, mm.
NodeVector Unloading::Simulation::displacement_to_mesh() const {
  NodeVector result = body_.vertex_positions();
  result -= state_.unloaded;
  result.update_ghost_values();
  return result;
}

double Unloading::Simulation::move_to(const NodeVector& unloaded) {
  std::copy_n(unloaded.begin(), 3 * body_.n_owned_nodes(), state_.unloaded.begin());
  state_.unloaded.update_ghost_values();
  supports_.contacts().put_on_surfaces(state_.unloaded);
  state_.displacement = displacement_to_mesh();
  update_reference();
  integrator_.velocity() = 0.;
  state_.loading = 1.;
  NodeVector force = external_force_;
  return subtract_inner_forces(state_.displacement, force);
}

double Unloading::Simulation::adopt(const NodeVector& unloaded) {
  const double jacobian = move_to(unloaded);
  state_.ramp_time = 0.;
  state_.force = 0.;
  state_.force_increment = 0.;
  state_.force.add(-1., out_of_balance());
  return jacobian;
}

NodeVector Unloading::Simulation::out_of_balance() {
  update_external_force();
  NodeVector force = external_force_;
  subtract_inner_forces(displacement_to_mesh(), force);
  return force;
}

/// Subtracts the forces of elements and springs; returns the smallest J.
double Unloading::Simulation::subtract_inner_forces(const NodeVector& displacement,
                                                    NodeVector& force) {
  const double jacobian =
      Utilities::MPI::min(internal_force_.subtract(displacement, force), body_.communicator());
  supports_.add_spring_forces(displacement, force);
  return jacobian;
}

} // namespace prosup::unloading
