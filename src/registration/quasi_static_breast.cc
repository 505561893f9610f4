#include "prosup/registration/quasi_static_breast.h"

#include <limits>

#include "prosup/mechanics/static/support_force.h"
#include "prosup/mesh/deformation.h"

namespace prosup::registration {

using mechanics::NodeVector;
using mechanics::QuasiStatic;

namespace {

constexpr double largest_change = 1e-3; // mm, of positions when areas have settled

double largest_difference(const NodeVector& a, const NodeVector& b) {
  NodeVector difference = a;
  difference -= b;
  return difference.linfty_norm();
}

/// The positions that a mesh has, with ghosts.
NodeVector mesh_positions(const mechanics::Body& body) {
  NodeVector positions = body.vertex_positions();
  positions.update_ghost_values();
  return positions;
}

/// Newton's method set up for a breast.
struct Newton {
  Newton(ElementBreast& breast, const QuasiStaticInput& input)
      : nodal_force(mechanics::support_force(breast.supports(), input.contact_stiffness)),
        solver(input.parameters, breast.body(), input.log) {
    solver.set_material(breast.material());
    solver.set_fixed_nodes(breast.supports().fixed());
    solver.set_nodal_force(nodal_force.get());
    solver.set_body_force(input.body_force);
    breast.supports().set_reference(mesh_positions(breast.body()));
  }

  std::unique_ptr<mechanics::NodalForce> nodal_force;
  QuasiStatic solver;
};

/// Positions at the nodes of the mesh, on the first rank.
std::vector<dealii::Point<3>> at_nodes(const mesh::TetMesh& mesh, const mechanics::Body& body,
                                       NodeVector& positions) {
  positions.update_ghost_values();
  const auto at_cells = body.gather_at_cells(positions);
  return at_cells.empty() ? std::vector<dealii::Point<3>>() : mesh::at_nodes(mesh, at_cells);
}

} // namespace

QuasiStaticSolution unload_quasi_statically(ElementBreast& breast, const QuasiStaticInput& input) {
  Newton newton(breast, input);
  QuasiStaticSolution solution;
  NodeVector unloaded = mesh_positions(breast.body());
  // The areas on which springs act are those of the unloaded configuration.
  for (double change = std::numeric_limits<double>::max(); change > largest_change;) {
    const NodeVector before = unloaded;
    solution.result = newton.solver.unload(breast.body().vertex_positions(), unloaded);
    breast.supports().set_reference(unloaded);
    change =
        breast.supports().spring_stiffness().empty() ? 0. : largest_difference(before, unloaded);
  }
  solution.mesh = breast.mesh();
  solution.mesh.unloaded = at_nodes(solution.mesh.mesh, breast.body(), unloaded);
  return solution;
}

QuasiStaticSolution load_quasi_statically(ElementBreast& breast, const QuasiStaticInput& input) {
  Newton newton(breast, input);
  QuasiStaticSolution solution;
  NodeVector displacement;
  breast.body().initialize(displacement);
  displacement.update_ghost_values();
  solution.result = newton.solver.load(breast.body().vertex_positions(), displacement);
  NodeVector loaded = mesh_positions(breast.body());
  loaded += displacement;
  solution.mesh = breast.mesh();
  solution.mesh.mesh.points = at_nodes(solution.mesh.mesh, breast.body(), loaded);
  return solution;
}

} // namespace prosup::registration
