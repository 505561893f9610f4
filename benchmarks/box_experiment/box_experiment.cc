// The experiment of the paper's appendix: a soft box is loaded and unloaded, on
// the same mesh and through voxels. Prints a table and writes box.csv and box.png.

#include <algorithm>
#include <cstdio>
#include <numeric>

#include "../setup.h"
#include "prosup/core/error.h"
#include "prosup/core/log.h"
#include "prosup/core/text_file.h"
#include "prosup/mesh/deformation.h"
#include "prosup/unloading/unloading.h"
#include "voxels.h"

using namespace dealii;
using namespace prosup;
using namespace prosup::benchmarks;
using mechanics::ElementType;
using mechanics::NodeVector;

namespace {

struct Options {
  unsigned n_truth = 8, n_same = 10;
  double voxel = 0.5, edge_length = 1.25, smoothing = 1., shift = 0.;
  std::string element = "nodal-pressure";
  bool newton = false;
};

struct Parameters : unloading::UnloadingParameters {
  explicit Parameters(const BoxExperiment& box) {
    fixed_boundaries = {static_cast<unsigned>(mesh::BoundaryPart::cut_plane)};
    gravity = box.gravity;
    residual_tolerance = 1e-5;
    position_tolerance = 1e-4;
    max_steps = 100000;
  }
};

/// Loaded or unloaded positions by the explicit method.
NodeVector simulate(const BoxExperiment& box, const mechanics::Body& body, Direction direction) {
  const Parameters parameters(box);
  unloading::Unloading simulation(parameters, body, box.direction, "the box");
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

mechanics::Element element_of(const std::string& name) {
  return {enumerator<ElementType>(name, mechanics::element_names())};
}

/// Loads a mesh of the cube and unloads the mesh that results.
std::vector<double> same_mesh_errors(const BoxExperiment& box, const Options& options) {
  const mechanics::Body cube = cube_body(box, options.n_same, element_of(options.element));
  const mesh::UnloadedMesh loaded =
      as_mesh(cube, simulate(box, cube, Direction::load), cube.vertex_positions());
  // The same cells with their nodes at the loaded positions.
  mesh::TetMesh mesh = loaded.mesh;
  for (const auto& c : mesh.cells)
    for (const std::array<unsigned, 3> f :
         {std::array<unsigned, 3>{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}}) {
      const std::array<unsigned, 3> nodes{c[f[0]], c[f[1]], c[f[2]]};
      if (std::all_of(nodes.begin(), nodes.end(),
                      [&](unsigned n) { return loaded.unloaded[n][1] > box.edge - 1e-9; }))
        mesh.boundary_faces.push_back({nodes, mesh::BoundaryPart::cut_plane});
    }
  const auto triangulation = mesh::make_distributed(mesh, MPI_COMM_SELF);
  const mechanics::Body body(*triangulation, element_of(options.element));
  const NodeVector unloaded = simulate(box, body, Direction::unload);
  const auto found = body.gather_at_cells(unloaded);
  std::vector<double> errors;
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
    for (unsigned a = 0; a < 4; ++a)
      errors.push_back(found[cell][a].distance(loaded.unloaded[mesh.cells[cell][a]]));
  return errors;
}

/// The mesh of a mask and its unloaded positions.
mesh::UnloadedMesh unload_mask(const BoxExperiment& box, const image::LabelImage& mask,
                               const Options& options) {
  mesh::MaskMesher mesher;
  mesher.edge_length = options.edge_length;
  mesher.smoothing = options.smoothing;
  mesh::UnloadedMesh result;
  result.mesh = mesher.run(mask);
  const auto triangulation = mesh::make_distributed(result.mesh, MPI_COMM_SELF);
  const mechanics::Body body(*triangulation, element_of(options.element));
  const NodeVector unloaded = options.newton
                                  ? solve(box, body, body.vertex_positions(), Direction::unload)
                                  : simulate(box, body, Direction::unload);
  const auto boundary = result.mesh.boundary_faces;
  if (body.element().degree() == 2)
    result = as_mesh(body, body.vertex_positions(), unloaded);
  else
    result.unloaded = mesh::at_nodes(result.mesh, body.gather_at_cells(unloaded));
  result.mesh.boundary_faces =
      body.element().degree() == 2 ? std::vector<mesh::BoundaryFace>() : boundary;
  return result;
}

void print(const char* what, const char* measure, const std::vector<double>& errors) {
  if (errors.empty())
    return;
  const Distances d = statistics(errors);
  std::printf("| %s | %s | %zu | %.4f | %.4f | %.4f |\n", what, measure, errors.size(), d.max,
              d.p95, d.mean);
  std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv) {
  CLI::App app{"Loads and unloads a soft box, on one mesh and through voxels.",
               "benchmark_box_experiment"};
  Options options;
  BoxExperiment box;
  std::filesystem::path folder;
  double weight = 2.;
  std::vector<double> direction{0., -1., 0.};
  app.add_option("--output", folder)->check(CLI::ExistingDirectory);
  app.add_option("--edge-length", options.edge_length)->capture_default_str();
  app.add_option("--smoothing", options.smoothing)->capture_default_str();
  app.add_option("--shift", options.shift)->capture_default_str();
  app.add_option("--voxel", options.voxel)->capture_default_str();
  app.add_option("--element", options.element)->capture_default_str();
  app.add_option("--truth", options.n_truth)->capture_default_str();
  app.add_option("--gravity", weight)->capture_default_str();
  app.add_option("--direction", direction)->expected(3);
  app.add_flag("--newton", options.newton);
  return run_program(argc, argv, app, [&] {
    box.gravity = weight * 9810.;
    box.direction = Tensor<1, 3>({direction[0], direction[1], direction[2]});
    const mechanics::Body fine = cube_body(box, options.n_truth, {ElementType::quadratic});
    const NodeVector loaded = solve(box, fine, fine.vertex_positions(), Direction::load);
    const mesh::UnloadedMesh truth = as_mesh(fine, loaded, fine.vertex_positions());
    std::vector<double> motion;
    for (std::size_t i = 0; i < truth.unloaded.size(); ++i)
      motion.push_back(truth.unloaded[i].distance(truth.mesh.points[i]));
    const image::LabelImage mask = rasterise(truth.mesh, options.voxel, box.edge, options.shift);
    const mesh::UnloadedMesh recovered = unload_mask(box, mask, options);
    std::printf(
        "softness %.2f; volumes: cube %.1f, loaded %.1f, voxels %.1f, mesh %.1f, recovered %.1f "
        "mm^3; "
        "%zu cells, %zu nodes\n",
        box.softness(), volume(truth.mesh, truth.unloaded), volume(truth.mesh, truth.mesh.points),
        0.5 * std::accumulate(mask.values.begin(), mask.values.end(), 0.) *
            mask.grid.voxel_volume(),
        volume(recovered.mesh, recovered.mesh.points), volume(recovered.mesh, recovered.unloaded),
        recovered.mesh.cells.size(), recovered.mesh.points.size());
    std::printf("| | measure | points | max, mm | p95 | mean |\n|---|---|---|---|---|---|\n");
    print("motion", "", motion);
    print("same mesh", "nodes", same_mesh_errors(box, options));
    print("through voxels", "displacement at voxels", displacement_errors(mask, recovered, truth));
    print("through voxels", "displacement at nodes", node_errors(recovered, truth));
    print("through voxels", "surface", surface_distances(recovered, box.edge));
  });
}
