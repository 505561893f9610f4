#include "runner.h"

#include <chrono>
#include <cmath>
#include <limits>
#include <regex>

#include "prosup/core/error.h"
#include "prosup/mechanics/static/quasi_static.h"
#include "prosup/mesh/distributed.h"
#include "prosup/mesh/mask_mesher.h"
#include "prosup/mesh/refine.h"
#include "prosup/unloading/unloading.h"

namespace prosup::benchmarks {

using namespace dealii;
using mechanics::Body;
using mechanics::NodeVector;
using unloading::UnloadingParameters;

namespace {

constexpr double near_enough = 0.05;       // mm
constexpr double largest_difference = 0.1; // of the parts of the weight that can be unloaded
constexpr double voxel = 2.;               // mm

mesh::TetMesh make_mesh(const Case& hard_case, Size size) {
  const Labels label_values;
  mesh::MaskMesher mesher(label_values);
  mesher.edge_length = size == Size::small ? hard_case.small_edge : hard_case.full_edge;
  mesh::TetMesh mesh = mesher.mesh(hard_case.shape.image(voxel, hard_case.axes));
  for (unsigned i = 0; i < hard_case.n_refinements; ++i)
    mesh = refined(mesh);
  if (hard_case.edit)
    hard_case.edit(mesh);
  return mesh;
}

std::vector<mechanics::LameParameters> material_of(const Case& hard_case, const Body& body) {
  std::vector<mechanics::LameParameters> result;
  for (const unsigned label : body.material_ids()) {
    const auto factor = hard_case.stiffness.find(label);
    result.push_back(mechanics::lame_parameters(
        hard_case.shear_modulus * (factor == hard_case.stiffness.end() ? 1. : factor->second),
        hard_case.poisson_ratio));
  }
  return result;
}

/// The parameters of the program, and what the case changes.
struct CaseParameters : UnloadingParameters {
  explicit CaseParameters(const Case& hard_case) {
    gravity *= hard_case.gravity;
    if (hard_case.settings)
      hard_case.settings(*this);
  }
};

/// Chest wall and cut planes.
const mechanics::BoundaryIds held{1, 2};

/// A number in an explanation; 0 if it is not there.
double number_after(const std::string& words, const std::string& text) {
  std::smatch match;
  return std::regex_search(text, match, std::regex(words + " ([0-9.e+-]*[0-9])"))
             ? std::stod(match[1])
             : 0.;
}

/// Newton's solution X, and the part of the weight up to which there is one.
double solve_by_newton(const Case& hard_case, const Body& body,
                       const UnloadingParameters& parameters, NodeVector& unloaded) {
  const mechanics::QuasiStaticParameters newton;
  mechanics::QuasiStatic solver(newton, body);
  solver.set_material(material_of(hard_case, body));
  solver.set_fixed_nodes(nodes_on_boundary(body, held));
  const Tensor<1, 3>& direction = hard_case.gravity_direction;
  solver.set_body_force(parameters.density * parameters.gravity / direction.norm() * direction);
  unloaded = body.vertex_positions();
  unloaded.update_ghost_values();
  if (parameters.gravity == 0.)
    return 1.;
  try {
    solver.unload(body.vertex_positions(), unloaded);
    return 1.;
  } catch (const DivergenceError& error) {
    return number_after("no equilibrium beyond", error.what());
  }
}

double max_distance(const NodeVector& a, const NodeVector& b, const Body& body) {
  double largest = 0.;
  bool is_finite = true;
  for (unsigned node = 0; node < body.n_owned_nodes(); ++node) {
    const double distance =
        (mechanics::node_value(a, node) - mechanics::node_value(b, node)).norm();
    is_finite = is_finite && std::isfinite(distance);
    largest = std::max(largest, distance);
  }
  return Utilities::MPI::max(is_finite ? largest : std::numeric_limits<double>::infinity(),
                             body.communicator());
}

/// Unloads, and fills the result but for the comparison.
void unload(const Case& hard_case, const Body& body, const UnloadingParameters& parameters,
            NodeVector& unloaded, Result& result) {
  mechanics::Supports supports(body, held);
  unloading::Unloading simulation(parameters, supports, hard_case.gravity_direction);
  simulation.set_observer([&](unsigned n_steps) {
    result.n_steps = n_steps;
    return true;
  });
  try {
    simulation.set_material(material_of(hard_case, body));
    const settling::SettlingResult settled = simulation.run();
    result.n_steps = settled.n_steps;
    result.n_retries = settled.n_retries;
    result.explanation = settled.explanation;
    result.outcome = settled.converged ? Outcome::settled : Outcome::not_settled;
  } catch (const DivergenceError& error) {
    result.explanation = error.what();
    result.n_retries = parameters.max_retries;
    result.outcome = Outcome::no_unloaded_state;
  }
  unloaded = simulation.unloaded();
}

bool is_as_expected(const Case& hard_case, const Result& result) {
  const bool says_why = result.explanation.find(hard_case.expected_words) != std::string::npos;
  if (result.outcome != hard_case.expected || !says_why || !result.is_finite ||
      result.n_retries < hard_case.expected_retries)
    return false;
  switch (result.outcome) {
  case Outcome::settled:
    return result.is_compared && result.distance < near_enough;
  case Outcome::no_unloaded_state: {
    const double fraction = number_after("exists up to", result.explanation);
    return fraction > 0. && std::abs(fraction - result.newton_fraction) < largest_difference;
  }
  case Outcome::not_settled:
  case Outcome::refused:
    return !result.explanation.empty();
  }
  return false;
}

} // namespace

Result run(const Case& hard_case, Size size) {
  const bool is_root = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
  const auto triangulation =
      make_distributed(is_root ? make_mesh(hard_case, size) : mesh::TetMesh(), MPI_COMM_WORLD);
  const Body body(*triangulation, mechanics::ElementParameters().element());
  const CaseParameters parameters(hard_case);
  Result result;
  result.n_cells = body.n_global_cells();
  NodeVector expected, found;
  result.newton_fraction = solve_by_newton(hard_case, body, parameters, expected);

  body.initialize(found);
  const auto start = std::chrono::steady_clock::now();
  try {
    unload(hard_case, body, parameters, found, result);
  } catch (const Error& error) {
    result.outcome = Outcome::refused;
    result.explanation = error.what();
  }
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  result.distance = max_distance(found, expected, body);
  result.is_finite = std::isfinite(result.distance);
  result.is_compared = result.newton_fraction == 1. && result.outcome == Outcome::settled;
  result.as_expected = is_as_expected(hard_case, result);
  return result;
}

} // namespace prosup::benchmarks
