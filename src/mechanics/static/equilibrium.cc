#include "equilibrium.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include "mechanics/element/membrane.h"
#include "mechanics/element/nodal_pressure.h"
#include "prosup/core/error.h"

namespace prosup::mechanics {

using namespace dealii;

namespace {

void add_to_nodes(const Body& body, unsigned element, const ElementVector& values,
                  NodeVector& vector) {
  for (unsigned a = 0; a < body.element().n_nodes(); ++a)
    for (unsigned c = 0; c < 3; ++c)
      vector.local_element(3 * body.element_nodes(element)[a] + c) += values[a][c];
}

} // namespace

Equilibrium::Equilibrium(const Body& body)
    : body_(body), shape_(element_shape(body.element().type)), fixed_(body.n_local_nodes(), false) {
  body.initialize(nodal_load_);
}

void Equilibrium::set_material(const Material& material) {
  if (!material.is_uniform() && material.size() != body_.n_elements())
    throw Error("The material of the quasi-static solver has " + std::to_string(material.size()) +
                " entries for " + std::to_string(body_.n_elements()) +
                " elements; give one for all or one for each element.");
  material_ = material;
  skin_ = membrane_triangles(body_, material.skin());
}

void Equilibrium::set_external_force(const Tensor<1, 3>& body_force, const NodeVector& nodal) {
  body_force_ = body_force;
  std::copy_n(nodal.begin(), 3 * body_.n_owned_nodes(), nodal_load_.begin());
}

void Equilibrium::set_problem(Unknown unknown, const NodeVector& known) {
  unknown_ = unknown;
  known_ = &known;
}

void Equilibrium::check() const {
  const MPI_Comm communicator = body_.communicator();
  if (Utilities::MPI::max(static_cast<int>(material_.is_empty() && body_.n_elements() > 0),
                          communicator))
    throw Error("The quasi-static solver has no material; call set_material() before load() and "
                "unload().");
  const auto n_fixed = std::count(fixed_.begin(), fixed_.end(), true);
  if (nodal_force_ == nullptr && Utilities::MPI::max(static_cast<int>(n_fixed), communicator) == 0)
    throw Error("Nothing holds the body of the quasi-static solver; fix some of its nodes or give "
                "it a nodal force.");
}

int Equilibrium::global_node(unsigned local_node) const {
  return static_cast<int>(nodal_load_.get_partitioner()->local_to_global(3 * local_node) / 3);
}

void Equilibrium::add_external_force(const NodeVector& unknown, double factor,
                                     NodeVector& force) const {
  for (unsigned e = 0; e < body_.n_elements(); ++e) {
    const ElementVector X = element_positions(body_, e, unloaded(unknown));
    ElementVector weight;
    for (unsigned q = 0; q < shape_.n_points; ++q) {
      const double volume = point_kinematics(shape_, q, X, X).volume;
      for (unsigned a = 0; a < shape_.n_nodes; ++a)
        weight[a] += factor * volume * shape_.value[q][a] * body_force_;
    }
    add_to_nodes(body_, e, weight, force);
  }
  for (unsigned i = 0; i < 3 * body_.n_owned_nodes(); ++i)
    force.local_element(i) += factor * nodal_load_.local_element(i);
}

double Equilibrium::external_force_norm(const NodeVector& unknown) const {
  NodeVector force;
  body_.initialize(force);
  add_external_force(unknown, 1., force);
  force.compress(VectorOperation::add);
  double squares = 0.;
  for (unsigned node = 0; node < body_.n_owned_nodes(); ++node)
    if (!fixed_[node])
      squares += node_value(force, node).norm_square();
  const double norm = std::sqrt(Utilities::MPI::sum(squares, body_.communicator()));
  return norm > 0. ? norm : 1.;
}

template <typename L>
double Equilibrium::add_element_forces(const L& law, const NodeVector& unknown,
                                       NodeVector& force) const {
  NodalPressure pressure(body_);
  if (averages_pressure())
    pressure.evaluate(material_, unloaded(unknown), loaded(unknown));
  double min_jacobian = std::numeric_limits<double>::max();
  for (unsigned e = 0; e < body_.n_elements(); ++e) {
    const ElementVector X = element_positions(body_, e, unloaded(unknown)),
                        x = element_positions(body_, e, loaded(unknown));
    const double p = averages_pressure() ? pressure.element_pressure(e) : 0.;
    ElementVector of_nodes;
    for (unsigned q = 0; q < shape_.n_points; ++q) {
      const PointKinematics point = point_kinematics(shape_, q, X, x);
      min_jacobian = std::isfinite(point.jacobian) ? std::min(min_jacobian, point.jacobian) : -1.;
      if (!(min_jacobian > 0.))
        return min_jacobian;
      add_internal_force(point, shape_.n_nodes, point_response(law, e, point).stress, p, of_nodes);
    }
    add_to_nodes(body_, e, of_nodes, force);
  }
  return min_jacobian;
}

void Equilibrium::add_skin_forces(const NodeVector& unknown, NodeVector& force) const {
  for (const auto& triangle : skin_) {
    const auto forces =
        MembraneTriangle(corners_of(triangle, unloaded(unknown)),
                         corners_of(triangle, loaded(unknown)), material_.skin().stiffness)
            .forces();
    for (unsigned a = 0; a < 3; ++a)
      for (unsigned c = 0; c < 3; ++c)
        force.local_element(3 * triangle[a] + c) += forces[a][c];
  }
}

double Equilibrium::residual(const NodeVector& unknown, NodeVector& residual) const {
  residual.zero_out_ghost_values();
  residual = 0.;
  const double min_jacobian = std::visit(
      [&](const auto& law) { return add_element_forces(law, unknown, residual); }, material_.law());
  add_skin_forces(unknown, residual);
  add_external_force(unknown, -load_fraction_, residual);
  residual.compress(VectorOperation::add);
  for (unsigned node = 0; node < body_.n_owned_nodes(); ++node) {
    Tensor<1, 3> force;
    Tensor<2, 3> by_x, by_X;
    const bool follows =
        nodal_force_ != nullptr && !fixed_[node] &&
        nodal_force_->evaluate(node, node_value(unloaded(unknown), node),
                               node_value(loaded(unknown), node), force, by_x, by_X);
    for (unsigned c = 0; c < 3; ++c) {
      double& value = residual.local_element(3 * node + c);
      value = fixed_[node] ? 0. : follows ? value - force[c] : value;
    }
  }
  return Utilities::MPI::min(min_jacobian, body_.communicator());
}

} // namespace prosup::mechanics
