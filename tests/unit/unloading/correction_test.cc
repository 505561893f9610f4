#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "loaded_box.h"
#include "prosup/core/error.h"
#include "static_box.h"

namespace prosup::tests {
namespace {

using namespace dealii;

const Tensor<1, 3> down({0., -1., 0.});
constexpr double edge = 60.; // mm: rho g edge = 589 Pa

/// Unloads a hanging box imaged as a cube.
struct HangingCube {
  explicit HangingCube(const HangingBoxParameters& parameters, double shear_modulus)
      : mesh(make_box(MPI_COMM_WORLD, {4, 4, 4}, {edge, edge, edge})), body(*mesh),
        supports(body, {3}), unloading(parameters, supports, down, "the cube") {
    unloading.set_material({mechanics::lame_parameters(shear_modulus, 0.45)});
    result = unloading.run();
  }

  std::unique_ptr<Distributed> mesh;
  mechanics::Body body;
  mechanics::Supports supports;
  unloading::Unloading unloading;
  settling::SettlingResult result;
};

TEST(Correction, FullAndRelaxedFindTheSameStateOfAStiffBody) {
  HangingBoxParameters parameters;
  parameters.max_retries = 0;
  const HangingCube relaxed(parameters, 600.);
  for (const unsigned interval : {1u, 10u, 50u}) {
    parameters.correction = "full";
    parameters.correction_interval = interval;
    const HangingCube full(parameters, 600.);
    EXPECT_TRUE(full.result.converged) << interval;
    EXPECT_LT(largest_difference(full.unloading.unloaded(), relaxed.unloading.unloaded()), 1e-3);
  }
}

TEST(Correction, FullDivergesWhereRelaxedDoesNotAndStaysFull) {
  HangingBoxParameters parameters;
  parameters.max_retries = 2;
  const double soft = 70.;
  EXPECT_TRUE(HangingCube(parameters, soft).result.converged);
  parameters.correction = "full";
  parameters.correction_interval = 50;
  try {
    const HangingCube full(parameters, soft);
    FAIL() << "converged: " << full.result.converged << " in " << full.result.n_steps;
  } catch (const DivergenceError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("'Unloading/Correction scheme' = relaxed"), std::string::npos)
        << message;
    EXPECT_NE(message.find("2 retries"), std::string::npos) << message;
  }
}

} // namespace
} // namespace prosup::tests
