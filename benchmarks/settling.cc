// How many steps and seconds each way of damping needs until a body is within
// 0.1 mm of its settled state everywhere. The settled state is Newton's.

#include <algorithm>
#include <chrono>
#include <limits>

#include "prosup/core/error.h"
#include "prosup/mechanics/static/quasi_static.h"
#include "prosup/unloading/unloading.h"
#include "setup.h"

using namespace dealii;
using namespace prosup;
using mechanics::NodeVector;

namespace {

constexpr double near_enough = 0.1; // mm
constexpr unsigned most_steps = 6000;

/// A body, its material and gravity, and Newton's solutions in either direction.
struct Scene {
  mechanics::Body body;
  const mechanics::Material material;
  const Tensor<1, 3> gravity;
  NodeVector unloaded, displacement; ///< X of the mesh as loaded; u of the mesh as unloaded
  double newton_time[2] = {0., 0.};  ///< s

  Scene(const mesh::TetMesh& mesh, double shear_modulus, double poisson_ratio,
        const unloading::UnloadingParameters& parameters)
      : body(*mesh::make_distributed(mesh, MPI_COMM_WORLD)), material{mechanics::lame_parameters(
                                                                 shear_modulus, poisson_ratio)},
        gravity({0., -1., 0.}) {
    mechanics::QuasiStaticParameters newton;
    ParameterHandler defaults;
    read_parameters(defaults, {}, {});
    mechanics::QuasiStatic solver(newton, body);
    solver.set_material(material);
    solver.set_fixed_nodes(nodes_on_boundary(body, {1, 2}));
    solver.set_body_force(parameters.density * parameters.gravity * gravity);
    const NodeVector& positions = body.vertex_positions();
    unloaded = positions;
    unloaded.update_ghost_values();
    body.initialize(displacement);
    newton_time[0] = seconds([&] { solver.unload(positions, unloaded); });
    newton_time[1] = seconds([&] { solver.load(positions, displacement); });
  }

  template <typename Work>
  static double seconds(Work work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }
};

struct Settled {
  unsigned n_steps = 0;
  unsigned n_retries = 0;
  double seconds = 0.;
  bool reached = false;
};

double max_distance(const NodeVector& a, const NodeVector& b, const mechanics::Body& body) {
  double largest = 0.;
  for (unsigned node = 0; node < body.n_owned_nodes(); ++node)
    largest =
        std::max(largest, (mechanics::node_value(a, node) - mechanics::node_value(b, node)).norm());
  return Utilities::MPI::max(largest, body.communicator());
}

/// Steps until the body is near its settled state and stays there for a while.
Settled settle(const Scene& scene, const unloading::UnloadingParameters& parameters, bool forward) {
  constexpr unsigned steps_near = 100;
  mechanics::Supports supports(scene.body, {1, 2});
  unloading::Unloading simulation(parameters, supports, scene.gravity);
  if (forward)
    simulation.hold_reference();
  Settled result;
  const auto start = std::chrono::steady_clock::now();
  simulation.set_observer([&](unsigned n_steps) {
    const double distance =
        forward ? max_distance(simulation.displacement(), scene.displacement, scene.body)
                : max_distance(simulation.unloaded(), scene.unloaded, scene.body);
    if (!(distance < near_enough)) {
      result.n_steps = 0;
      return true;
    }
    if (result.n_steps == 0) {
      result.n_steps = n_steps;
      result.seconds =
          std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }
    result.reached = n_steps >= result.n_steps + steps_near;
    return !result.reached;
  });
  try {
    simulation.set_material(scene.material);
    result.n_retries = simulation.run().n_retries;
  } catch (const DivergenceError&) {
    result.reached = false;
  }
  return result;
}

void print(const std::string& scheme, double fraction, const Settled& unloading,
           const Settled& loading) {
  const auto text = [](const Settled& s) {
    char buffer[64];
    std::snprintf(buffer, sizeof buffer, "%u%s | %.2f", s.n_steps,
                  s.n_retries > 0 ? (" (" + std::to_string(s.n_retries) + " retries)").c_str() : "",
                  s.seconds);
    return s.reached ? std::string(buffer) : std::string("not settled | ");
  };
  std::printf("| %s | %.1f | %s | %s |\n", scheme.c_str(), fraction, text(unloading).c_str(),
              text(loading).c_str());
  std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv) {
  CLI::App app{"Steps until a body has settled, for each way of damping.", "benchmark_settling"};
  std::string labels = PROSUP_SAMPLE_LABELS;
  double edge_length = 6.5, shear_modulus = 325., poisson_ratio = 0.45;
  app.add_option("--labels", labels, "Label image of a prone breast")->capture_default_str();
  app.add_option("--edge-length", edge_length, "mm")->capture_default_str();
  app.add_option("--shear-modulus", shear_modulus, "Pa")->capture_default_str();
  app.add_option("--poisson-ratio", poisson_ratio)->capture_default_str();
  return benchmarks::run_program(argc, argv, app, [&] {
    unloading::UnloadingParameters parameters;
    parameters.residual_tolerance = parameters.position_tolerance =
        1e-9; // until the observer stops
    parameters.max_steps = most_steps;
    const bool is_root = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
    mesh::TetMesh mesh;
    if (is_root)
      mesh = benchmarks::MeshSource(labels).mesh(edge_length);
    const Scene scene(mesh, shear_modulus, poisson_ratio, parameters);
    if (is_root)
      std::printf("%s; %u tetrahedra, mu %g Pa, nu %g\n\n"
                  "| damping | mass-scaled part | unloading: steps | s | loading: steps | s |\n"
                  "|---|---|---|---|---|---|\n"
                  "| Newton | | | %.2f | | %.2f |\n",
                  benchmarks::processor().c_str(), scene.body.n_global_cells(), shear_modulus,
                  poisson_ratio, scene.newton_time[0], scene.newton_time[1]);
    for (const std::string& scheme : mechanics::damping_names())
      for (const double fraction : {0., 0.2, 1.}) {
        parameters.damping = scheme;
        parameters.scaled_fraction = fraction;
        const Settled unloading = settle(scene, parameters, false);
        const Settled loading = settle(scene, parameters, true);
        if (is_root)
          print(scheme, fraction, unloading, loading);
      }
  });
}
