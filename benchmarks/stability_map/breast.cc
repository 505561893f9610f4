#include "breast.h"

#include <deal.II/grid/grid_generator.h>

#include <algorithm>
#include <cmath>

#include "prosup/core/error.h"
#include "prosup/mechanics/body/boundary.h"

namespace prosup::benchmarks {

using namespace dealii;
using mechanics::node_value;
using mechanics::NodeVector;

namespace {

mechanics::Body half_ball(unsigned n_refinements) {
  Triangulation<3> ball, hexahedra, tetrahedra;
  GridGenerator::half_hyper_ball(ball, Point<3>(), breast_depth);
  ball.refine_global(n_refinements);
  GridGenerator::flatten_triangulation(ball, hexahedra);
  GridGenerator::convert_hypercube_to_simplex_mesh(hexahedra, tetrahedra);
  return mechanics::Body(tetrahedra, mechanics::Element{mechanics::ElementType::nodal_pressure});
}

} // namespace

HalfBall::HalfBall(double softness, bool prone, unsigned n_refinements)
    : body(half_ball(n_refinements)),
      gravity({prone ? 1. : -1., 0., 0.}), material{mechanics::lame_parameters(
                                               specific_weight * breast_depth / softness,
                                               breast_poisson_ratio)},
      fixed(nodes_on_boundary(body, {1})) {
  mechanics::QuasiStaticParameters parameters;
  mechanics::QuasiStatic newton(parameters, body);
  newton.set_material(material);
  newton.set_fixed_nodes(fixed);
  newton.set_body_force(specific_weight * gravity);
  unloaded = body.vertex_positions();
  unloaded.update_ghost_values();
  try {
    has_solution = newton.unload(body.vertex_positions(), unloaded).converged;
  } catch (const DivergenceError&) {
  }
  unloaded.update_ghost_values();
  motion = max_distance(unloaded, body.vertex_positions());
}

double max_distance(const NodeVector& a, const NodeVector& b) {
  double largest = 0.;
  for (unsigned node = 0; 3 * node < a.locally_owned_size(); ++node)
    largest = std::max(largest, (node_value(a, node) - node_value(b, node)).norm());
  return largest;
}

} // namespace prosup::benchmarks
