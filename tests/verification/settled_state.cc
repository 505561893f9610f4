#include <gtest/gtest.h>

#include <cmath>

#include "figures.h"
#include "loaded_box.h"
#include "prosup/core/collective.h"
#include "prosup/image/image_io.h"
#include "prosup/mechanics/quasi_static.h"
#include "prosup/mesh/distributed.h"
#include "prosup/mesh/mask_mesher.h"

using namespace dealii;
using namespace prosup;
using namespace prosup::mechanics;
using tests::tell_figure;

namespace {

const Tensor<1, 3> prone({0., -1., 0.});

/// The prone breast of the small test data, on rank 0. Meshed once.
const mesh::TetMesh& breast() {
  static const mesh::TetMesh mesh = [] {
    mesh::TetMesh result;
    on_root(MPI_COMM_WORLD, [&] {
      mesh::MaskMesher mesher;
      mesher.edge_length = 14.;
      result = mesher.run(image::read_labels(PROSUP_TEST_DATA "/small/prone_labels.nii.gz"));
    });
    return result;
  }();
  return mesh;
}

enum class Way { forward, inverse };

/// Positions of the corners of all cells, on rank 0.
using Corners = std::vector<std::array<Point<3>, 4>>;

double largest_distance(const Corners& a, const Corners& b) {
  double largest = a.size() == b.size() ? 0. : 1e30;
  for (std::size_t cell = 0; cell < a.size(); ++cell)
    for (unsigned corner = 0; corner < 4; ++corner)
      largest = std::max(largest, a[cell][corner].distance(b[cell][corner]));
  return largest;
}

/// The breast as a body on the ranks of a communicator: fat and gland.
struct Breast {
  Breast(ElementType type, MPI_Comm communicator)
      : triangulation(mesh::make_distributed(breast(), communicator)),
        body(*triangulation, Element{type}) {
    for (const unsigned tissue : body.material_ids())
      material.push_back(lame_parameters(tissue == 3 ? 900. : 300., 0.45));
  }

  /// Settled positions: x of the body taken as unloaded, or X of it taken as loaded.
  Corners settle(Way way) const {
    tests::HangingBoxParameters parameters;
    Supports supports(body, {1, 2});
    unloading::Unloading simulation(parameters, supports, prone);
    if (way == Way::forward)
      simulation.hold_reference();
    simulation.set_material(material);
    EXPECT_TRUE(simulation.run().converged);
    NodeVector positions = simulation.unloaded();
    if (way == Way::forward)
      positions += simulation.displacement();
    positions.update_ghost_values();
    return body.gather_at_cells(positions);
  }

  /// The same by Newton's method.
  Corners solve(Way way) const {
    QuasiStaticParameters parameters;
    parameters.tolerance = 1e-10;
    QuasiStatic solver(parameters, body);
    solver.set_material(material);
    solver.set_fixed_nodes(body.nodes_on_boundary({1, 2}));
    solver.set_body_force(9.81 * prone);
    NodeVector result = body.vertex_positions();
    if (way == Way::forward) {
      NodeVector u;
      body.initialize(u);
      u.update_ghost_values();
      EXPECT_TRUE(solver.load(body.vertex_positions(), u).converged);
      result += u;
    } else {
      result.update_ghost_values();
      EXPECT_TRUE(solver.unload(body.vertex_positions(), result).converged);
    }
    result.update_ghost_values();
    return body.gather_at_cells(result);
  }

  std::unique_ptr<parallel::fullydistributed::Triangulation<3>> triangulation;
  Body body;
  std::vector<LameParameters> material;
};

int rank() {
  return static_cast<int>(Utilities::MPI::this_mpi_process(MPI_COMM_WORLD));
}

const char* name_of(Way way) {
  return way == Way::forward ? "forward loading" : "unloading";
}

} // namespace

class SettledState : public ::testing::TestWithParam<ElementType> {};

TEST_P(SettledState, ExplicitAgainstNewton) {
  const Breast breast(GetParam(), MPI_COMM_WORLD);
  for (const Way way : {Way::forward, Way::inverse}) {
    constexpr double bound = 0.01; // mm
    const Corners start = breast.body.gather_at_cells(breast.body.vertex_positions());
    const Corners settled = breast.settle(way), solved = breast.solve(way);
    const double distance = largest_distance(settled, solved);
    EXPECT_LT(distance, bound) << name_of(way);
    const double motion = largest_distance(start, solved);
    if (rank() == 0) {
      EXPECT_GT(motion, 2.) << name_of(way);
    }
    tell_figure(
        std::string("breast of the small test data, ") + name_of(way) + ", " +
            tests::name_of(GetParam()) +
            format(", %u nodes that move up to %.1f mm", breast.body.n_global_nodes(), motion),
        "explicit against Newton", format("%.1e mm at most", distance), format("%.2f mm", bound));
  }
}

TEST_P(SettledState, DoesNotDependOnTheRanks) {
  const unsigned n_ranks = Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
  if (n_ranks == 1)
    GTEST_SKIP() << "one rank is what others are compared with";
  constexpr double bound = 1e-6; // mm
  for (const Way way : {Way::forward, Way::inverse}) {
    const Breast shared(GetParam(), MPI_COMM_WORLD);
    const Corners settled = shared.settle(way), solved = shared.solve(way);
    if (rank() != 0)
      continue;
    const Breast alone(GetParam(), MPI_COMM_SELF);
    const double by_explicit = largest_distance(settled, alone.settle(way));
    const double by_newton = largest_distance(solved, alone.solve(way));
    EXPECT_LT(by_explicit, bound) << name_of(way);
    EXPECT_LT(by_newton, bound) << name_of(way);
    tell_figure(std::string("breast of the small test data, ") + name_of(way) + ", " +
                    tests::name_of(GetParam()),
                format("%u ranks against one", n_ranks),
                format("explicit %.1e mm, Newton %.1e mm", by_explicit, by_newton),
                format("%.0e mm", bound));
  }
}

INSTANTIATE_TEST_SUITE_P(Elements, SettledState, ::testing::ValuesIn(tests::all_element_types),
                         [](const auto& info) {
                           std::string name = tests::name_of(info.param);
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });
