#include "cube.h"

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include <cmath>

#include "prosup/mechanics/body/boundary.h"

namespace prosup::benchmarks {

using namespace dealii;
using mechanics::node_value;
using mechanics::NodeVector;

mechanics::Material BoxExperiment::material() const {
  return {mechanics::lame_parameters(youngs_modulus / (2. + 2. * poisson_ratio), poisson_ratio)};
}

mechanics::Body cube_body(const BoxExperiment& box, unsigned n, const mechanics::Element& element,
                          bool graded) {
  Triangulation<3> cube;
  GridGenerator::subdivided_hyper_rectangle_with_simplices(cube, {n, n, n}, Point<3>(),
                                                           Point<3>(box.edge, box.edge, box.edge));
  for (const auto& cell : cube.active_cell_iterators())
    for (const unsigned f : cell->face_indices())
      if (cell->face(f)->at_boundary())
        cell->face(f)->set_boundary_id(
            cell->face(f)->center()[1] > (1. - 1e-9) * box.edge
                ? static_cast<types::boundary_id>(mesh::BoundaryPart::cut_plane)
                : static_cast<types::boundary_id>(mesh::BoundaryPart::skin));
  if (graded)
    GridTools::transform(
        [&](const Point<3>& p) {
          const auto to_both = [&](double t) { return 0.5 - 0.5 * std::cos(numbers::PI * t); };
          const Point<3> t = p / box.edge;
          return box.edge *
                 Point<3>(to_both(t[0]), std::sin(0.5 * numbers::PI * t[1]), to_both(t[2]));
        },
        cube);
  return mechanics::Body(cube, element);
}

NodeVector solve_loaded(const BoxExperiment& box, const mechanics::Body& body) {
  const mechanics::QuasiStaticParameters parameters;
  mechanics::QuasiStatic newton(parameters, body);
  newton.set_material(box.material());
  newton.set_fixed_nodes(
      nodes_on_boundary(body, {static_cast<types::boundary_id>(mesh::BoundaryPart::cut_plane)}));
  newton.set_body_force(tissue_density * box.gravity * box.direction);
  NodeVector result;
  body.initialize(result);
  result.update_ghost_values();
  newton.load(body.vertex_positions(), result);
  result += body.vertex_positions();
  result.update_ghost_values();
  return result;
}

mesh::UnloadedMesh as_mesh(const mechanics::Body& body, const NodeVector& loaded,
                           const NodeVector& unloaded) {
  mesh::UnloadedMesh result;
  for (unsigned node = 0; node < body.n_owned_nodes(); ++node) {
    result.mesh.points.emplace_back(node_value(loaded, node));
    result.unloaded.emplace_back(node_value(unloaded, node));
  }
  result.mesh.cells = body.cells();
  result.mesh.tissue.assign(result.mesh.cells.size(), 2);
  return result;
}

double volume(const mesh::TetMesh& mesh, const std::vector<Point<3>>& points) {
  double sum = 0.;
  for (const auto& c : mesh.cells)
    sum += mesh::tet_volume(points[c[0]], points[c[1]], points[c[2]], points[c[3]]);
  return sum;
}

} // namespace prosup::benchmarks
