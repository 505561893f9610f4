#include "unload.h"

#include <algorithm>

#include "prosup/core/error.h"
#include "prosup/mesh/deformation.h"
#include "prosup/mesh/distributed.h"
#include "prosup/mesh/mask_mesher.h"
#include "prosup/unloading/unloading.h"

namespace prosup::benchmarks {

using namespace dealii;
using mechanics::NodeVector;
using mesh::BoundaryPart;

namespace {

struct Parameters : unloading::UnloadingParameters {
  explicit Parameters(const BoxExperiment& box) {
    gravity = box.gravity;
    residual_tolerance = 1e-5; // errors of the method, not of stopping early
    position_tolerance = 1e-4;
  }
};

/// Positions that the explicit method loads or unloads the body to.
NodeVector simulate(const BoxExperiment& box, const mechanics::Body& body, Direction direction) {
  const Parameters parameters(box);
  mechanics::Supports supports(body, {static_cast<types::boundary_id>(BoundaryPart::cut_plane)});
  unloading::Unloading simulation(parameters, supports, box.direction, "the box");
  if (direction == Direction::load)
    simulation.hold_reference();
  simulation.set_material(box.material());
  if (!simulation.run().converged)
    throw DivergenceError("The box did not settle.");
  NodeVector result = simulation.unloaded();
  if (direction == Direction::load)
    result += simulation.displacement();
  result.update_ghost_values();
  return result;
}

/// Names the faces that lie in the plane y = edge when unloaded.
void add_held_faces(mesh::UnloadedMesh& loaded, double edge) {
  constexpr unsigned faces[4][3] = {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}};
  for (const auto& c : loaded.mesh.cells)
    for (const auto& f : faces) {
      const std::array<unsigned, 3> nodes{c[f[0]], c[f[1]], c[f[2]]};
      if (std::all_of(nodes.begin(), nodes.end(),
                      [&](unsigned node) { return loaded.unloaded[node][1] > (1. - 1e-9) * edge; }))
        loaded.mesh.boundary_faces.push_back({nodes, BoundaryPart::cut_plane});
    }
}

/// Unloads a mesh as it is.
std::vector<Point<3>> unload(const BoxExperiment& box, const mesh::TetMesh& mesh) {
  const auto triangulation = mesh::make_distributed(mesh, MPI_COMM_SELF);
  const mechanics::Body body(*triangulation, {box_element});
  return mesh::at_nodes(mesh, body.gather_at_cells(simulate(box, body, Direction::unload)));
}

} // namespace

std::vector<double> same_mesh_errors(const BoxExperiment& box, unsigned n) {
  const mechanics::Body cube = cube_body(box, n, {box_element}, false);
  mesh::UnloadedMesh loaded =
      as_mesh(cube, simulate(box, cube, Direction::load), cube.vertex_positions());
  add_held_faces(loaded, box.edge);
  const std::vector<Point<3>> found = unload(box, loaded.mesh);
  std::vector<double> errors;
  for (std::size_t node = 0; node < found.size(); ++node)
    errors.push_back(found[node].distance(loaded.unloaded[node]));
  return errors;
}

mesh::UnloadedMesh unload_mask(const BoxExperiment& box, const image::LabelImage& mask,
                               double edge_length) {
  const Labels label_values;
  mesh::MaskMesher mesher(label_values);
  mesher.edge_length = edge_length;
  mesh::UnloadedMesh result;
  result.mesh = mesher.mesh(mask);
  result.unloaded = unload(box, result.mesh);
  return result;
}

} // namespace prosup::benchmarks
