#include "prosup/unloading/unloading.h"

#include <deal.II/base/mpi.h>
#include <gtest/gtest.h>

#include <cmath>

#include "loaded_box.h"
#include "prosup/core/error.h"
#include "prosup/mechanics/laws/material.h"

namespace prosup::tests {
namespace {

using namespace dealii;
using mechanics::node_value;
using mechanics::NodeVector;
using settling::SettlingResult;
using unloading::Unloading;
using unloading::UnloadingParameters;

const Tensor<1, 3> down({0., -1., 0.});

double extreme_height(const mechanics::Body& body, const NodeVector& positions, double sign) {
  double extreme = -1e30;
  for (unsigned node = 0; node < body.n_owned_nodes(); ++node)
    extreme = std::max(extreme, sign * node_value(positions, node)[1]);
  return sign * Utilities::MPI::max(extreme, MPI_COMM_WORLD);
}

constexpr unsigned n_edges = 4;
constexpr double edge = 15.;

LoadedBox load_box(const std::vector<mechanics::LameParameters>& material,
                   const UnloadingParameters& parameters) {
  return LoadedBox({n_edges, n_edges, n_edges}, {edge, edge, edge}, material, parameters, down);
}

/// Largest distance between the unloaded positions found and the box the
/// loaded one was made of, over all ranks, mm.
double unloading_error(const LoadedBox& box, const mechanics::Body& body,
                       const Unloading& unloading) {
  double largest = 0.;
  for (unsigned node = 0; node < body.n_owned_nodes(); ++node) {
    const Point<3> found(node_value(unloading.unloaded(), node));
    const Point<3> loaded(node_value(body.vertex_positions(), node));
    largest = std::max(largest, box.unloaded(loaded).distance(found));
  }
  return Utilities::MPI::max(largest, MPI_COMM_WORLD);
}

struct UnloadedBox {
  double error;
  SettlingResult result;
};

UnloadedBox unload_box(const UnloadingParameters& parameters, const LoadedBox& box,
                       const std::vector<mechanics::LameParameters>& material) {
  const auto mesh = make_box(MPI_COMM_WORLD, {n_edges, n_edges, n_edges}, {edge, edge, edge}, box);
  const mechanics::Body body(*mesh);
  mechanics::Supports supports(body, {3});
  Unloading unloading(parameters, supports, down);
  unloading.set_material(material);
  const SettlingResult result = unloading.run();
  return {unloading_error(box, body, unloading), result};
}

// nu = 0: the column hangs in one dimension, P = mu (F - 1/F) = rho g s at the
// distance s from its free end, hence F = (P + sqrt(P^2 + 4 mu^2)) / (2 mu).
TEST(Loading, HangingColumnAgainstItsExactSolution) {
  const double length = 100., mu = 500.;
  const auto mesh = make_box(MPI_COMM_WORLD, {1, 50, 1}, {4., length, 4.});
  const mechanics::Body body(*mesh);
  HangingBoxParameters parameters;
  parameters.damping_rate = 25.;
  parameters.scaled_fraction = 0.;
  mechanics::Supports supports(body, {3});
  Unloading loading(parameters, supports, down);
  loading.hold_reference();
  loading.set_material({mechanics::lame_parameters(mu, 0.)});
  ASSERT_TRUE(loading.run().converged);
  NodeVector x = loading.displacement();
  x += body.vertex_positions();

  double tip = 0.; // integral of F - 1 over the length
  const unsigned n = 20000;
  for (unsigned i = 0; i < n; ++i) {
    const double P = 1e-3 * 9810. * (i + 0.5) * length / n;
    tip += ((P + std::sqrt(P * P + 4. * mu * mu)) / (2. * mu) - 1.) * length / n;
  }
  EXPECT_GT(tip, 40.); // large strain
  EXPECT_NEAR(extreme_height(body, x, -1.), -tip, 0.01);
}

// The box of the paper's appendix: 15 mm, E = 500 Pa, nu = 0.45, with a body
// force strong enough to sag visibly.
TEST(Unloading, RecoversTheBoxThatWasLoaded) {
  const std::vector<mechanics::LameParameters> material{
      mechanics::lame_parameters(500. / 2.9, 0.45)};
  HangingBoxParameters parameters;
  parameters.gravity = 2. * standard_gravity;
  const LoadedBox box = load_box(material, parameters);
  EXPECT_LT(box(Point<3>(0., 0., 0.))[1], -3.); // it sags
  const UnloadedBox unloaded = unload_box(parameters, box, material);
  EXPECT_TRUE(unloaded.result.converged);
  EXPECT_LT(unloaded.error, 0.005);
}

TEST(Unloading, ResultDoesNotDependOnTheWayThere) {
  const std::vector<mechanics::LameParameters> material{mechanics::lame_parameters(200., 0.4)};
  HangingBoxParameters parameters;
  const LoadedBox box = load_box(material, parameters);
  for (const std::string damping : {"fixed", "lowest-frequency", "adaptive"})
    for (const double scaled : {0., 1.})
      for (const double lag : {2.5, 6.}) {
        parameters.damping = damping;
        parameters.damping_rate = 50.;
        parameters.lag_factor = lag;
        parameters.scaled_fraction = scaled;
        parameters.gravity_ramp = scaled == 0. ? 0. : 4.;
        EXPECT_LT(unload_box(parameters, box, material).error, 0.005)
            << damping << " " << scaled << " " << lag;
      }
}

TEST(Unloading, GoesBackAndGivesUpWithADiagnosis) {
  const std::vector<mechanics::LameParameters> jelly{mechanics::lame_parameters(4., 0.45)};
  const auto mesh = make_box(MPI_COMM_WORLD, {4, 4, 4}, {60., 60., 60.});
  const mechanics::Body body(*mesh);
  HangingBoxParameters parameters;
  parameters.max_retries = 2;
  mechanics::Supports supports(body, {3});
  Unloading unloading(parameters, supports, -down, "the test body");
  unloading.set_material(jelly);
  try {
    unloading.run();
    FAIL() << "a body this soft has no unloaded state";
  } catch (const DivergenceError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("the test body diverged at step"), std::string::npos) << message;
    EXPECT_NE(message.find("2 retries"), std::string::npos) << message;
    EXPECT_EQ(message.find("nan"), std::string::npos) << message;
    for (const char* words : {"cell ", " mm with J = ", "rho g L/mu = 1.5e+02", "of the weight"})
      EXPECT_NE(message.find(words), std::string::npos) << message;
  }
  for (unsigned i = 0; i < 3 * body.n_owned_nodes(); ++i)
    EXPECT_TRUE(std::isfinite(unloading.unloaded().local_element(i)));
}

// A body under twice the weight that it can be unloaded from, which is known: under that of
// which it was made by loading there is a state.
TEST(Unloading, SaysForWhichPartOfTheWeightThereIsAState) {
  const std::vector<mechanics::LameParameters> material{mechanics::lame_parameters(8., 0.3)};
  HangingBoxParameters parameters;
  const auto mesh = make_box(MPI_COMM_WORLD, {4, 4, 4}, {60., 60., 60.});
  const mechanics::Body body(*mesh);
  parameters.residual_tolerance = 2e-3;
  parameters.position_tolerance = 0.02;
  parameters.max_retries = 2;
  mechanics::Supports supports(body, {3});
  Unloading unloading(parameters, supports, -down);
  unloading.set_material(material);
  try {
    unloading.run();
    FAIL() << "a body this soft has no unloaded state";
  } catch (const DivergenceError& error) {
    const std::string message = error.what(), words = "exists up to ";
    ASSERT_NE(message.find(words), std::string::npos) << message;
    const double part = std::stod(message.substr(message.find(words) + words.size()));
    // The same body under nearly that part of the weight settles at once.
    parameters.gravity *= 0.9 * part;
    parameters.lag_factor = 10.;
    parameters.gravity_ramp = 40.;
    Unloading lighter(parameters, supports, -down);
    lighter.set_material(material);
    EXPECT_TRUE(lighter.run().converged) << message;
  }
}

TEST(Unloading, AbsurdDampingIsMended) {
  const std::vector<mechanics::LameParameters> material{mechanics::lame_parameters(300., 0.45)};
  HangingBoxParameters parameters;
  const LoadedBox box = load_box(material, parameters);
  parameters.damping = "fixed";
  parameters.damping_rate = 1e5;
  const UnloadedBox unloaded = unload_box(parameters, box, material);
  EXPECT_GT(unloaded.result.n_retries, 0u);
  EXPECT_TRUE(unloaded.result.converged);
  EXPECT_LT(unloaded.error, 0.005);
}

TEST(Unloading, SaysWhyItHasNotSettled) {
  const std::vector<mechanics::LameParameters> material{mechanics::lame_parameters(300., 0.45)};
  HangingBoxParameters parameters;
  const LoadedBox box = load_box(material, parameters);
  EXPECT_EQ(unload_box(parameters, box, material).result.explanation, "");
  parameters.max_steps = 50;
  const SettlingResult result = unload_box(parameters, box, material).result;
  EXPECT_FALSE(result.converged);
  EXPECT_NE(result.explanation.find("did not settle in 50 steps"), std::string::npos)
      << result.explanation;
}

TEST(Unloading, StepThatIsTooLargeIsAnsweredBySmallerOnes) {
  const std::vector<mechanics::LameParameters> material{mechanics::lame_parameters(300., 0.45)};
  HangingBoxParameters parameters;
  const LoadedBox box = load_box(material, parameters);
  parameters.step_safety = 2.;
  parameters.scaled_fraction = 0.;
  const UnloadedBox unloaded = unload_box(parameters, box, material);
  EXPECT_GT(unloaded.result.n_retries, 0u);
  EXPECT_TRUE(unloaded.result.converged);
  EXPECT_LT(unloaded.error, 0.005);
}

TEST(Unloading, RejectsWhatCannotBeSimulated) {
  const auto mesh = make_box(MPI_COMM_WORLD, {2, 2, 2}, {10., 10., 10.});
  const mechanics::Body body(*mesh);
  HangingBoxParameters parameters;
  mechanics::Supports held(body, {3}), loose(body, {77});
  EXPECT_THROW(Unloading(parameters, held, Tensor<1, 3>()), Error);
  EXPECT_THROW(Unloading(parameters, loose, down), Error);
  parameters.damping_rate = 0.;
  EXPECT_THROW(Unloading(parameters, held, down), Error);
}

} // namespace
} // namespace prosup::tests
