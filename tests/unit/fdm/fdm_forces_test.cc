#include <deal.II/base/mpi.h>
#include <gtest/gtest.h>

#include <cmath>

#include "prosup/fdm/fdm_unloading.h"
#include "voxel_box.h"

namespace prosup::tests {
namespace {

using namespace dealii;

constexpr double depth = 20.; // mm
const VoxelBox layer{1., 80., depth, 8.};
const Tensor<1, 3> down({0., -standard_gravity, 0.}), sideways({standard_gravity, 0., 0.});

fdm::Material stiff() {
  fdm::Material result;
  result.tissues[2] = {2000., 3000.};
  return result;
}

struct CoarseParameters : fdm::FdmParameters {
  CoarseParameters() {
    spacing = 2.5;
    padding = 10.;
    background_stiffness = 0.01;
  }
};

/// `part` of the weight of the layer as a force density on the grid.
fdm::VectorField weight(const fdm::FdmUnloading& simulation, double part) {
  fdm::VectorField result{simulation.grid(), {}};
  for (std::size_t k = 0; k < result.grid.size[2]; ++k)
    for (std::size_t j = 0; j < result.grid.size[1]; ++j)
      for (std::size_t i = 0; i < result.grid.size[0]; ++i)
        result.values.push_back(
            layer.label(result.grid.physical(double(i), double(j), double(k))) == 2
                ? part * tissue_density * down
                : Tensor<1, 3>());
  return result;
}

double sag(const fdm::FdmUnloading& simulation) {
  return -simulation.displacement().value(Point<3>(0., -0.75 * depth, 0.))[1];
}

class FdmForces : public ::testing::Test {
protected:
  FdmForces() : simulation(parameters, {layer.labels(), 1, stiff(), down}, MPI_COMM_WORLD) {
    simulation.hold_reference();
    EXPECT_TRUE(simulation.run().converged);
  }
  const CoarseParameters parameters;
  fdm::FdmUnloading simulation;
};

TEST_F(FdmForces, AddWeightToWeight) {
  // Strains are small: u(Y) = rho g (L Y - Y^2/2)/(2 mu + lambda).
  const double Y = 0.75 * depth;
  const double exact =
      tissue_density * standard_gravity * (depth * Y - 0.5 * Y * Y) / (2. * 2000. + 3000.);
  const double once = sag(simulation);
  EXPECT_NEAR(once, exact, 0.12 * exact); // the surface is smeared over a cell

  simulation.add_force(weight(simulation, 1.), 0.05);
  ASSERT_TRUE(simulation.run().converged);
  EXPECT_NEAR(sag(simulation), 2. * once, 0.15 * once);
  simulation.add_force(weight(simulation, -2.), 0.05);
  ASSERT_TRUE(simulation.run().converged);
  EXPECT_NEAR(sag(simulation), 0., 0.15 * once);
}

TEST_F(FdmForces, AreForgottenWithTheirState) {
  const auto before = simulation.save();
  const fdm::VectorField u = simulation.displacement();
  simulation.add_force(weight(simulation, 1.), 0.05);
  ASSERT_TRUE(simulation.run().converged);
  ASSERT_GT(
      (simulation.displacement().value(Point<3>(0., -15., 0.)) - u.value(Point<3>(0., -15., 0.)))
          .norm(),
      0.1);
  simulation.restore(before);
  const fdm::VectorField restored = simulation.displacement();
  for (std::size_t node = 0; node < u.values.size(); ++node)
    ASSERT_EQ(u.values[node], restored.values[node]);
  // It is at rest there: the force is gone too.
  const settling::SettlingResult result = simulation.advance(50);
  EXPECT_LT(result.residual, parameters.residual_tolerance);
  const fdm::VectorField later = simulation.displacement();
  for (std::size_t node = 0; node < u.values.size(); ++node)
    ASSERT_LT((u.values[node] - later.values[node]).norm(), 0.02);
}

TEST(FdmSliding, LayerHangsOnItsSprings) {
  // Springs on the chest carry a layer that gravity pulls along it: k u = rho g L there.
  const CoarseParameters parameters;
  const double stiffness = 100.; // Pa/mm
  const double exact = tissue_density * standard_gravity * depth / stiffness;
  fdm::FdmUnloading simulation(
      parameters, {layer.labels(), 1, stiff(), sideways, {fdm::ChestContact::sliding, stiffness}},
      MPI_COMM_WORLD);
  simulation.hold_reference();
  const settling::SettlingResult result = simulation.run();
  ASSERT_TRUE(result.converged) << result.explanation;
  const fdm::VectorField u = simulation.displacement();
  EXPECT_NEAR(u.value(Point<3>())[0], exact, 0.1 * exact);
  EXPECT_NEAR(u.value(Point<3>())[1], 0., 0.01 * exact);
  simulation.set_spring_stiffness(2. * stiffness);
  ASSERT_TRUE(simulation.run().converged);
  EXPECT_NEAR(simulation.displacement().value(Point<3>())[0], 0.5 * exact, 0.05 * exact);
}

} // namespace
} // namespace prosup::tests
