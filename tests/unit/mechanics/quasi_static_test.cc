#include "prosup/mechanics/body/boundary.h"
#include "prosup/mechanics/static/quasi_static.h"

#include <deal.II/base/mpi.h>
#include <gtest/gtest.h>

#include <cmath>

#include "expect_error.h"
#include "static_box.h"

namespace prosup::tests {
namespace {

using namespace dealii;
using namespace prosup::mechanics;

const Tensor<1, 3> weight({0., -9.81, 0.}); // g/(mm^2 s^2), of 1 g/cm^3

using Box = StaticBox;

/// Springs of stiffness k (g/s^2) that hold the nodes marked at where they were
/// unloaded.
struct Springs : NodalForce {
  std::vector<bool> held;
  double k = 0.;

  bool evaluate(unsigned node, const Tensor<1, 3>& X, const Tensor<1, 3>& x, Tensor<1, 3>& force,
                Tensor<2, 3>& by_x, Tensor<2, 3>& by_X) const override {
    if (!held[node])
      return false;
    force = -k * (x - X);
    by_x = -k * Tensor<2, 3>(unit_symmetric_tensor<3>());
    by_X = -by_x;
    return true;
  }
};

// nu = 0: the column hangs in one dimension, P = mu (F - 1/F) = rho g s at the
// distance s from its free end, hence F = (P + sqrt(P^2 + 4 mu^2)) / (2 mu).
TEST(QuasiStatic, HangingColumnAgainstItsExactSolution) {
  const double length = 100., mu = 500.;
  Box column({1, 25, 1}, {4., length, 4.}, ElementType::quadratic, lame_parameters(mu, 0.));
  const QuasiStaticResult result =
      column.solver.load(column.body.vertex_positions(), column.displacement);
  EXPECT_TRUE(result.converged);
  EXPECT_LT(result.residual, column.parameters.tolerance);

  double tip = 0.; // integral of F - 1 over the length
  const unsigned n = 20000;
  for (unsigned i = 0; i < n; ++i) {
    const double P = 9.81 * (i + 0.5) * length / n;
    tip += ((P + std::sqrt(P * P + 4. * mu * mu)) / (2. * mu) - 1.) * length / n;
  }
  EXPECT_GT(tip, 40.); // large strain
  double lowest = 0.;
  for (unsigned node = 0; node < column.body.n_owned_nodes(); ++node)
    lowest = std::min(lowest, node_value(column.displacement, node)[1]);
  EXPECT_NEAR(Utilities::MPI::min(lowest, MPI_COMM_WORLD), -tip, 0.001);
}

class RoundTrip : public ::testing::TestWithParam<ElementType> {};

TEST_P(RoundTrip, ReturnsToTheUnloadedBoxAndDoesNotDependOnTheLinearAlgebra) {
  NodeVector first;
  for (const std::string& linear_algebra : linear_algebra_names()) {
    SCOPED_TRACE(linear_algebra);
    Box box({3, 3, 3}, {60., 60., 60.}, GetParam(), lame_parameters(400., 0.45), linear_algebra);
    box.solver.load(box.body.vertex_positions(), box.displacement);
    EXPECT_GT(box.displacement.linfty_norm(), 10.);
    if (first.size() == 0)
      first = box.displacement;
    EXPECT_LT(largest_difference(first, box.displacement), 1e-6);
    const NodeVector x = box.loaded();
    NodeVector X = x;
    X.update_ghost_values();
    const QuasiStaticResult result = box.solver.unload(x, X);
    EXPECT_TRUE(result.converged);
    EXPECT_GT(result.min_jacobian, 0.);
    EXPECT_LT(largest_difference(X, box.body.vertex_positions()), 1e-5);
  }
}

INSTANTIATE_TEST_SUITE_P(Elements, RoundTrip,
                         ::testing::Values(ElementType::linear, ElementType::nodal_pressure,
                                           ElementType::quadratic));

// Such as one of two bodies that ranks share.
TEST(QuasiStatic, RanksMaySolveAlone) {
  for (const std::string& linear_algebra : linear_algebra_names())
    if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0) {
      Box box({2, 2, 2}, {20., 20., 20.}, ElementType::linear, lame_parameters(400., 0.4),
              linear_algebra, MPI_COMM_SELF);
      EXPECT_TRUE(box.solver.load(box.body.vertex_positions(), box.displacement).converged);
    }
}

// An affine displacement of the whole surface is that of the inside too.
TEST(QuasiStatic, FixedNodesKeepPrescribedDisplacements) {
  for (const ElementType type :
       {ElementType::linear, ElementType::nodal_pressure, ElementType::quadratic}) {
    Box box({3, 2, 3}, {6., 5., 7.}, type, lame_parameters(300., 0.45));
    const std::vector<bool> fixed = nodes_on_boundary(box.body, {0, 1, 2, 3, 4, 5});
    box.solver.set_fixed_nodes(fixed);
    box.solver.set_body_force({});
    NodeVector affine;
    box.body.initialize(affine);
    for (unsigned node = 0; node < box.body.n_owned_nodes(); ++node) {
      const Tensor<1, 3> X = node_value(box.body.vertex_positions(), node);
      affine.local_element(3 * node) = 0.2 * X[0] + 0.1 * X[1] - 1.;
      affine.local_element(3 * node + 1) = -0.1 * X[1] + 0.05 * X[2];
      affine.local_element(3 * node + 2) = 0.15 * X[0];
      for (unsigned c = 0; c < 3 && fixed[node]; ++c)
        box.displacement.local_element(3 * node + c) = affine.local_element(3 * node + c);
    }
    box.displacement.update_ghost_values();
    box.solver.load(box.body.vertex_positions(), box.displacement);
    EXPECT_LT(largest_difference(affine, box.displacement), 1e-7);
  }
}

TEST(QuasiStatic, SpringsCarryTheWeight) {
  Box box({3, 3, 3}, {30., 20., 30.}, ElementType::linear, lame_parameters(2000., 0.4));
  Springs springs;
  springs.held = nodes_on_boundary(box.body, {3});
  springs.k = 5000.;
  box.solver.set_fixed_nodes(std::vector<bool>(box.body.n_local_nodes(), false));
  box.solver.set_nodal_force(&springs);
  box.solver.load(box.body.vertex_positions(), box.displacement);
  Tensor<1, 3> pull;
  for (unsigned node = 0; node < box.body.n_owned_nodes(); ++node)
    if (springs.held[node])
      pull += -springs.k * node_value(box.displacement, node);
  pull = Utilities::MPI::sum(pull, MPI_COMM_WORLD);
  const Tensor<1, 3> carried = -30. * 20. * 30. * weight;
  for (unsigned c = 0; c < 3; ++c)
    EXPECT_NEAR(pull[c], carried[c], 1e-5 * carried.norm());

  const NodeVector x = box.loaded();
  NodeVector X = x;
  X.update_ghost_values();
  box.solver.unload(x, X);
  EXPECT_LT(largest_difference(X, box.body.vertex_positions()), 1e-5);
}

TEST(QuasiStatic, ConstantNodalForcesActAsTheirSum) {
  Box box({2, 2, 2}, {10., 10., 10.}, ElementType::linear, lame_parameters(2000., 0.4));
  NodeVector force;
  box.body.initialize(force);
  for (unsigned node = 0; node < box.body.n_owned_nodes(); ++node)
    force.local_element(3 * node) = 30.;
  Springs springs;
  springs.held = nodes_on_boundary(box.body, {3});
  springs.k = 5000.;
  box.solver.set_fixed_nodes(std::vector<bool>(box.body.n_local_nodes(), false));
  box.solver.set_nodal_force(&springs);
  box.solver.set_body_force({});
  box.solver.set_external_force(force);
  box.solver.load(box.body.vertex_positions(), box.displacement);
  double pull = 0.;
  for (unsigned node = 0; node < box.body.n_owned_nodes(); ++node)
    if (springs.held[node])
      pull += springs.k * box.displacement.local_element(3 * node);
  EXPECT_NEAR(Utilities::MPI::sum(pull, MPI_COMM_WORLD), 30. * 27., 1e-3);
}

TEST(QuasiStatic, TooSoftABodyIsADivergence) {
  for (const char* linear_algebra : {"petsc-direct", "trilinos-direct"}) {
    Box box({3, 3, 3}, {60., 60., 60.}, ElementType::linear, lame_parameters(4., 0.45),
            linear_algebra);
    box.parameters.max_halvings = 2;
    box.solver.set_body_force(-weight); // standing, not hanging
    try {
      box.solver.load(box.body.vertex_positions(), box.displacement);
      FAIL() << "a body this soft does not stand";
    } catch (const DivergenceError& error) {
      const std::string message = error.what();
      EXPECT_NE(message.find("of the load"), std::string::npos) << message;
      EXPECT_NE(message.find("2 halvings"), std::string::npos) << message;
      EXPECT_EQ(message.find("nan"), std::string::npos) << message;
      EXPECT_EQ(message.find("inf"), std::string::npos) << message;
    }
    for (unsigned i = 0; i < box.displacement.locally_owned_size(); ++i)
      EXPECT_TRUE(std::isfinite(box.displacement.local_element(i)));
  }
}

TEST(QuasiStatic, HalvesLoadStepsThatFail) {
  Box box({3, 3, 3}, {60., 60., 60.}, ElementType::linear, lame_parameters(200., 0.45));
  box.parameters.max_iterations = 4;
  const QuasiStaticResult result = box.solver.load(box.body.vertex_positions(), box.displacement);
  EXPECT_GT(result.n_load_steps, 1u);
  Box patient({3, 3, 3}, {60., 60., 60.}, ElementType::linear, lame_parameters(200., 0.45));
  EXPECT_EQ(patient.solver.load(patient.body.vertex_positions(), patient.displacement).n_load_steps,
            1u);
  EXPECT_LT(largest_difference(box.displacement, patient.displacement), 1e-6);
}

TEST(QuasiStatic, RefusesWhatItCannotSolve) {
  const auto mesh = make_box(MPI_COMM_WORLD, {2, 2, 2}, {10., 10., 10.});
  const Body body(*mesh);
  QuasiStaticParameters parameters;
  QuasiStatic solver(parameters, body);
  NodeVector u;
  body.initialize(u);
  const auto load = [&] { solver.load(body.vertex_positions(), u); };
  expect_error(load, {"no material"});
  expect_error(
      [&] {
        solver.set_material(std::vector<LameParameters>{{1., 1.}, {1., 1.}});
      },
      {"2 entries"});
  solver.set_material({{100., 100.}});
  expect_error(load, {"Nothing holds"});
  solver.set_fixed_nodes(nodes_on_boundary(body, {3}));
  parameters.linear_algebra = "abacus";
  expect_error(load, {"abacus", "petsc-gamg"});
}

} // namespace
} // namespace prosup::tests
