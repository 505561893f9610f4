// Time of the internal forces per element and step, as ratios to a plain scalar
// loop in the same run, and the speed-up of several ranks.

#include <algorithm>
#include <chrono>
#include <memory>

#include "prosup/mechanics/explicit/central_differences.h"
#include "setup.h"

using namespace dealii;
using namespace prosup;
using namespace prosup::mechanics;

namespace {

/// The scalar loop everything is compared with: one linear tetrahedron after
/// another, as one would write it down.
class ScalarLoop {
public:
  ScalarLoop(const Body& body, const LameParameters& material) : material_(material) {
    for (unsigned e = 0; e < body.n_elements(); ++e) {
      Cell cell;
      std::copy_n(body.element_nodes(e), 4, cell.nodes);
      Tensor<2, 3> D;
      for (unsigned b = 0; b < 3; ++b)
        for (unsigned c = 0; c < 3; ++c)
          D[c][b] = body.vertex_positions().local_element(3 * cell.nodes[b + 1] + c) -
                    body.vertex_positions().local_element(3 * cell.nodes[0] + c);
      cell.volume = determinant(D) / 6.;
      D = invert(D);
      for (unsigned b = 0; b < 3; ++b)
        for (unsigned c = 0; c < 3; ++c)
          cell.gradient[b][c] = D[b][c];
      cells_.push_back(cell);
    }
  }

  void subtract(const double* u, double* force) const {
    for (const Cell& cell : cells_) {
      double F[3][3], cofactor[3][3];
      for (unsigned i = 0; i < 3; ++i)
        for (unsigned j = 0; j < 3; ++j) {
          F[i][j] = i == j;
          for (unsigned b = 0; b < 3; ++b)
            F[i][j] +=
                (u[3 * cell.nodes[b + 1] + i] - u[3 * cell.nodes[0] + i]) * cell.gradient[b][j];
        }
      for (unsigned i = 0; i < 3; ++i)
        for (unsigned j = 0; j < 3; ++j)
          cofactor[i][j] = F[(i + 1) % 3][(j + 1) % 3] * F[(i + 2) % 3][(j + 2) % 3] -
                           F[(i + 1) % 3][(j + 2) % 3] * F[(i + 2) % 3][(j + 1) % 3];
      const double J =
          F[0][0] * cofactor[0][0] + F[0][1] * cofactor[0][1] + F[0][2] * cofactor[0][2];
      const double pressure = (material_.lambda * std::log(J) - material_.mu) / J;
      for (unsigned c = 0; c < 3; ++c) {
        double P[3];
        for (unsigned j = 0; j < 3; ++j)
          P[j] = cell.volume * (material_.mu * F[c][j] + pressure * cofactor[c][j]);
        for (unsigned b = 0; b < 3; ++b) {
          const double f =
              P[0] * cell.gradient[b][0] + P[1] * cell.gradient[b][1] + P[2] * cell.gradient[b][2];
          force[3 * cell.nodes[b + 1] + c] -= f;
          force[3 * cell.nodes[0] + c] += f;
        }
      }
    }
  }

private:
  struct Cell {
    double gradient[3][3], volume;
    unsigned nodes[4];
  };
  const LameParameters material_;
  std::vector<Cell> cells_;
};

/// Shortest of several runs, s: what disturbs only adds.
template <typename Work>
double shortest_time(unsigned n_runs, Work work) {
  double shortest = 1e30;
  for (unsigned run = 0; run < n_runs; ++run) {
    const auto start = std::chrono::steady_clock::now();
    work();
    shortest = std::min(
        shortest, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  return shortest;
}

const LameParameters material = lame_parameters(325., 0.45);

NodeVector wavy_displacement(const Body& body) {
  NodeVector u;
  body.initialize(u);
  for (unsigned i = 0; i < 3 * body.n_owned_nodes(); ++i)
    u.local_element(i) = 0.5 * std::sin(0.05 * body.vertex_positions().local_element(i) + i % 3);
  u.update_ghost_values();
  return u;
}

/// A body of a mesh with its forces, ready to be timed.
struct Subject {
  std::unique_ptr<parallel::fullydistributed::Triangulation<3>> triangulation;
  Body body;
  InternalForce forces;
  NodeVector u, result;

  Subject(const mesh::TetMesh& mesh, const Element& element, MPI_Comm communicator)
      : triangulation(mesh::make_distributed(mesh, communicator)), body(*triangulation, element),
        forces(body), u(wavy_displacement(body)) {
    forces.set_material({material});
    forces.set_reference(body.vertex_positions());
    body.initialize(result);
  }

  double force_time(unsigned n_runs) {
    return shortest_time(n_runs, [&] { forces.subtract(u, result); });
  }

  /// A whole step of the integrator, in rest.
  double step_time(unsigned n_runs) {
    const Supports nothing(body);
    CentralDifferences integrator(nothing, forces);
    integrator.set_mass({std::vector<double>(body.n_local_nodes(), 1e9), 1e-6, 0.}, 1.);
    NodeVector external;
    body.initialize(external);
    return shortest_time(n_runs, [&] { integrator.step(external, u); });
  }
};

void compare_elements(const benchmarks::MeshSource& source, unsigned n_cells, unsigned n_runs) {
  const mesh::TetMesh mesh = source.mesh_of(n_cells);
  const double n = static_cast<double>(mesh.cells.size());
  Subject plain(mesh, Element(), MPI_COMM_SELF);
  const ScalarLoop loop(plain.body, material);
  std::printf("\n%.0f tetrahedra, one core; ns per element and step, speed over the scalar loop\n"
              "| element | precision | instruction set | forces | whole step | speed |\n"
              "|---|---|---|---|---|---|\n",
              n);
  const auto scalar_time = [&] {
    return shortest_time(n_runs, [&] { loop.subtract(plain.u.begin(), plain.result.begin()); });
  };
  const double scalar = scalar_time();
  std::printf("| linear | double | scalar loop | %.1f | | 1 |\n", 1e9 * scalar / n);
  for (const auto type : {ElementType::linear, ElementType::nodal_pressure, ElementType::quadratic})
    for (const auto precision : {Precision::double_precision, Precision::single_precision})
      for (const std::string& set : instruction_set_names())
        try {
          Subject subject(mesh, {type, precision, set}, MPI_COMM_SELF);
          const double forces = subject.force_time(n_runs), step = subject.step_time(n_runs);
          std::printf("| %s | %s | %s | %.1f | %.1f | %.2f |\n",
                      element_names()[static_cast<unsigned>(type)].c_str(),
                      precision_names()[static_cast<unsigned>(precision)].c_str(), set.c_str(),
                      1e9 * forces / n, 1e9 * step / n, std::min(scalar, scalar_time()) / forces);
        } catch (const Error&) { // not on this processor
        }
  const double reference =
      shortest_time(n_runs, [&] { plain.forces.set_reference(plain.body.vertex_positions()); });
  std::printf("New reference configuration, linear, double: %.1f ns per element.\n",
              1e9 * reference / n);
}

/// Steps on one rank, while the others wait, and on all of them.
void compare_ranks(const benchmarks::MeshSource& source, unsigned n_cells, unsigned n_runs) {
  const int n_ranks = Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
  const bool is_root = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
  mesh::TetMesh mesh;
  if (is_root)
    mesh = source.mesh_of(n_cells);
  double alone = 0.;
  if (is_root)
    alone = Subject(mesh, Element(), MPI_COMM_SELF).step_time(n_runs);
  // Waiting ranks would spin on processors that others could use.
  MPI_Bcast(&alone, 1, MPI_DOUBLE, 0, MPI_COMM_WORLD);
  Subject subject(mesh, Element(), MPI_COMM_WORLD);
  const double together = Utilities::MPI::max(subject.step_time(n_runs), MPI_COMM_WORLD);
  if (is_root)
    std::printf("\n%zu tetrahedra, linear, double: a step takes %.3f ms on one rank and %.3f ms on "
                "%d, %.2f times as fast.\n",
                mesh.cells.size(), 1e3 * alone, 1e3 * together, n_ranks, alone / together);
}

} // namespace

int main(int argc, char** argv) {
  CLI::App app{"Time of the internal forces.", "benchmark_forces"};
  std::string labels = PROSUP_SAMPLE_LABELS;
  unsigned n_cells = 25000, n_cells_ranks = 100000, n_runs = 200;
  app.add_option("--labels", labels, "Label image to mesh")->capture_default_str();
  app.add_option("--cells", n_cells, "Tetrahedra on one rank")->capture_default_str();
  app.add_option("--cells-ranks", n_cells_ranks, "Tetrahedra for several ranks")
      ->capture_default_str();
  app.add_option("--runs", n_runs, "Runs, of which the shortest counts")->capture_default_str();
  return benchmarks::run_program(argc, argv, app, [&] {
    const benchmarks::MeshSource source(labels);
    if (Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) > 1) {
      compare_ranks(source, n_cells_ranks, n_runs);
      return;
    }
    std::printf("%s\n", benchmarks::processor().c_str());
    compare_elements(source, n_cells, n_runs);
  });
}
