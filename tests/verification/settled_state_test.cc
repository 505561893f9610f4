#include <gtest/gtest.h>

#include <cmath>

#include "figures.h"
#include "loaded_box.h"
#include "prosup/core/collective.h"
#include "prosup/image/image_io.h"
#include "prosup/mechanics/static/quasi_static.h"
#include "prosup/mechanics/static/support_force.h"
#include "prosup/mesh/distributed.h"
#include "prosup/mesh/mask_mesher.h"
#include "prosup/unloading/support_parameters.h"

namespace prosup::tests {
namespace {

using namespace dealii;
using namespace prosup::mechanics;
using unloading::ChestCondition;

const Tensor<1, 3> prone({0., -1., 0.});

image::LabelImage labels(const char* file) {
  return image::read_labels(std::string(PROSUP_TEST_DATA "/small/") + file);
}

/// The prone breast of the small test data, on rank 0. Meshed once.
const mesh::TetMesh& breast() {
  static const mesh::TetMesh mesh = [] {
    mesh::TetMesh result;
    on_root(MPI_COMM_WORLD, [&] {
      const Labels label_values;
      mesh::MaskMesher mesher(label_values);
      mesher.edge_length = 14.;
      result = mesher.mesh(labels("prone_labels.nii.gz"));
    });
    return result;
  }();
  return mesh;
}

// Of Newton's penalty, Pa/mm; it gives way by the pressure on the chest over this.
constexpr double contact_stiffness = 1e5;
// Springs act on areas of the unloaded shape, which Newton's method takes from the
// solution before.
constexpr unsigned n_area_updates = 3;

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
  Breast(ElementType type, ChestCondition chest, const Law& law, MPI_Comm communicator)
      : triangulation(mesh::make_distributed(breast(), communicator)),
        body(*triangulation, Element{type}),
        supports(parameters.make(chest, body, labels("prone_labels.nii.gz"),
                                 labels("supine_labels.mha"), 1)) {
    std::vector<LameParameters> of_elements;
    for (const unsigned tissue : body.material_ids())
      of_elements.push_back(lame_parameters(tissue == 3 ? 900. : 300., 0.45));
    material = {of_elements, law};
  }

  /// Settled positions: x of the body taken as unloaded, or X of it taken as loaded.
  Corners settle(Way way) const {
    HangingBoxParameters parameters;
    unloading::Unloading simulation(parameters, *supports, prone);
    if (way == Way::forward)
      simulation.hold_reference();
    simulation.set_material(material);
    EXPECT_TRUE(simulation.run().converged);
    EXPECT_LT(supports->contacts().largest_gap(simulation.unloaded(), simulation.displacement()),
              1e-3);
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
    const auto nodal_force = support_force(*supports, contact_stiffness);
    solver.set_fixed_nodes(supports->fixed());
    solver.set_nodal_force(nodal_force.get());
    solver.set_body_force(9.81 * prone);
    NodeVector result = body.vertex_positions();
    result.update_ghost_values();
    supports->set_reference(result);
    if (way == Way::forward) {
      NodeVector u;
      body.initialize(u);
      u.update_ghost_values();
      EXPECT_TRUE(solver.load(body.vertex_positions(), u).converged);
      result += u;
    } else {
      for (unsigned i = 0; i < n_area_updates; ++i) {
        EXPECT_TRUE(solver.unload(body.vertex_positions(), result).converged);
        supports->set_reference(result);
      }
    }
    result.update_ghost_values();
    return body.gather_at_cells(result);
  }

  std::unique_ptr<parallel::fullydistributed::Triangulation<3>> triangulation;
  Body body;
  Material material;
  unloading::SupportParameters parameters;
  std::unique_ptr<Supports> supports;
};

int rank() {
  return static_cast<int>(Utilities::MPI::this_mpi_process(MPI_COMM_WORLD));
}

const char* direction_of(Way way) {
  return way == Way::forward ? "forward loading" : "unloading";
}

struct Case {
  ElementType element;
  ChestCondition chest;
  Law law = NeoHookean();
};

std::string scene(const Case& c, Way way) {
  const char* chest = c.chest == ChestCondition::fixed ? "" : ", sliding on the chest";
  return std::string("breast of the small test data") + chest + ", " + direction_of(way) + ", " +
         name_of(c.element) + remark_on(c.law);
}

class SettledState : public ::testing::TestWithParam<Case> {};

TEST_P(SettledState, ExplicitAgainstNewton) {
  const auto [element, chest, law] = GetParam();
  const Breast breast(element, chest, law, MPI_COMM_WORLD);
  const double bound = chest == ChestCondition::fixed ? 0.01 : 0.02; // mm; the penalty gives way
  for (const Way way : {Way::forward, Way::inverse}) {
    const Corners start = breast.body.gather_at_cells(breast.body.vertex_positions());
    const Corners settled = breast.settle(way), solved = breast.solve(way);
    const double distance = largest_distance(settled, solved);
    EXPECT_LT(distance, bound) << direction_of(way);
    const double motion = largest_distance(start, solved);
    if (rank() == 0) {
      EXPECT_GT(motion, 2.) << direction_of(way);
    }
    tell_figure(scene(GetParam(), way) + format(", %u nodes that move up to %.1f mm",
                                                n_global_nodes(breast.body), motion),
                "explicit against Newton", format("%.1e mm at most", distance),
                format("%.2f mm", bound));
  }
}

TEST_P(SettledState, DoesNotDependOnTheRanks) {
  const unsigned n_ranks = Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
  if (n_ranks == 1)
    GTEST_SKIP() << "one rank is what others are compared with";
  constexpr double bound = 1e-6; // mm
  const auto [element, chest, law] = GetParam();
  for (const Way way : {Way::forward, Way::inverse}) {
    const Breast shared(element, chest, law, MPI_COMM_WORLD);
    const Corners settled = shared.settle(way), solved = shared.solve(way);
    if (rank() != 0)
      continue;
    const Breast alone(element, chest, law, MPI_COMM_SELF);
    const double by_explicit = largest_distance(settled, alone.settle(way));
    const double by_newton = largest_distance(solved, alone.solve(way));
    EXPECT_LT(by_explicit, bound) << direction_of(way);
    EXPECT_LT(by_newton, bound) << direction_of(way);
    tell_figure(scene(GetParam(), way), format("%u ranks against one", n_ranks),
                format("explicit %.1e mm, Newton %.1e mm", by_explicit, by_newton),
                format("%.0e mm", bound));
  }
}

INSTANTIATE_TEST_SUITE_P(
    Breasts, SettledState,
    ::testing::Values(Case{ElementType::linear, ChestCondition::fixed},
                      Case{ElementType::nodal_pressure, ChestCondition::fixed},
                      Case{ElementType::quadratic, ChestCondition::fixed},
                      Case{ElementType::linear, ChestCondition::sliding},
                      Case{ElementType::nodal_pressure, ChestCondition::sliding},
                      Case{ElementType::nodal_pressure, ChestCondition::fixed, Yeoh{{}, 3., 1.}},
                      Case{ElementType::quadratic, ChestCondition::fixed, Yeoh{{}, 3., 1.}}),
    [](const auto& info) {
      std::string name = name_of(info.param.element);
      std::replace(name.begin(), name.end(), '-', '_');
      if (info.param.law.index() > 0)
        name += "_" + name_of(info.param.law);
      return name + (info.param.chest == ChestCondition::fixed ? "_fixed" : "_sliding");
    });

} // namespace
} // namespace prosup::tests
