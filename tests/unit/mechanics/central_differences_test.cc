#include "prosup/mechanics/explicit/central_differences.h"

#include <deal.II/base/mpi.h>
#include <gtest/gtest.h>

#include <cmath>

#include "box.h"

namespace prosup::tests {
namespace {

using namespace dealii;
using namespace prosup::mechanics;

StableMass mass_of(const Supports& supports, const InternalForce& kernel, const NodeVector& u,
                   double scaled_fraction = 0.) {
  HighestFrequency highest_frequency(supports.body(), kernel);
  return stable_mass(supports, kernel, highest_frequency, u, 1e-3, scaled_fraction);
}

/// A free block that starts with a rough velocity field; returns the largest
/// kinetic energy over 2000 undamped steps, relative to the first.
double energy_growth(double safety) {
  const auto mesh = make_box(MPI_COMM_WORLD, {4, 4, 4}, {20., 25., 30.});
  const Body body(*mesh);
  InternalForce kernel(body);
  kernel.set_material({lame_parameters(300., 0.45)});
  kernel.set_reference(body.vertex_positions());
  NodeVector u, external;
  body.initialize(u);
  u.update_ghost_values();
  body.initialize(external);
  const Supports supports(body);
  CentralDifferences integrator(supports, kernel);
  integrator.set_mass(mass_of(supports, kernel, u), safety);
  for (unsigned i = 0; i < 3 * body.n_owned_nodes(); ++i)
    integrator.velocity().local_element(i) =
        1e-3 * std::sin(7.3 * body.vertex_positions().local_element(i) + 2. * (i % 3));
  integrator.step(external, u);
  const double start = integrator.report().kinetic_energy;
  double largest = start;
  for (unsigned i = 0; i < 2000; ++i) {
    integrator.step(external, u);
    const double energy = integrator.report().kinetic_energy;
    if (!std::isfinite(energy) || energy > 1e6 * start)
      return 1e6;
    largest = std::max(largest, energy);
  }
  return largest / start;
}

TEST(CentralDifferences, StableAtTheEstimatedCriticalStep) {
  EXPECT_LT(energy_growth(0.999), 4.);
}

TEST(CentralDifferences, UnstableTenPercentAboveTheEstimate) {
  EXPECT_GE(energy_growth(1.1), 1e6);
}

TEST(CentralDifferences, MassScalingOnlyRaisesMasses) {
  const auto mesh = make_box(MPI_COMM_WORLD, {4, 4, 4}, {20., 25., 30.}, [](const Point<3>& p) {
    return Point<3>(p[0] * p[0] / 20., p[1], p[2]);
  });
  const Body body(*mesh);
  InternalForce kernel(body);
  kernel.set_material({lame_parameters(300., 0.45)});
  kernel.set_reference(body.vertex_positions());
  NodeVector u;
  body.initialize(u);
  u.update_ghost_values();
  const Supports supports(body);
  const StableMass plain = mass_of(supports, kernel, u);
  const StableMass scaled = mass_of(supports, kernel, u, 0.3);
  EXPECT_GT(scaled.critical_step, 1.2 * plain.critical_step);
  // Nodes at the same distance from the limit are raised together or not at all.
  EXPECT_NEAR(scaled.scaled_fraction, 0.3, 0.1);
  for (std::size_t node = 0; node < plain.mass.size(); ++node)
    EXPECT_GE(scaled.mass[node], plain.mass[node] * (1. - 1e-12));
}

TEST(CentralDifferences, FallsFreelyAndFixedNodesStay) {
  const auto mesh = make_box(MPI_COMM_WORLD, {2, 2, 2}, {10., 10., 10.});
  const Body body(*mesh);
  InternalForce kernel(body);
  kernel.set_material({lame_parameters(300., 0.3)});
  kernel.set_reference(body.vertex_positions());
  NodeVector u, weight;
  body.initialize(u);
  u.update_ghost_values();
  body.initialize(weight);
  const std::vector<double> volume = kernel.lumped_volume();
  for (unsigned node = 0; node < body.n_owned_nodes(); ++node)
    weight.local_element(3 * node + 1) = -1e-3 * 9810. * volume[node];
  const Supports supports(body);
  CentralDifferences integrator(supports, kernel);
  integrator.set_mass(mass_of(supports, kernel, u), 0.9);
  for (unsigned i = 0; i < 50; ++i)
    integrator.step(weight, u);
  // u^n = -g h^2 n (n + 1) / 2 exactly, for every node.
  const double h = integrator.time_step();
  for (unsigned node = 0; node < body.n_owned_nodes(); ++node)
    EXPECT_NEAR(u.local_element(3 * node + 1), -9810. * h * h * 50. * 51. / 2., 1e-9);

  const Supports surface(body, {0, 1, 2, 3, 4, 5});
  CentralDifferences held(surface, kernel);
  held.set_mass(mass_of(surface, kernel, u), 0.9);
  u = 0.;
  held.step(weight, u);
  for (unsigned node = 0; node < body.n_owned_nodes(); ++node)
    EXPECT_EQ(u.local_element(3 * node + 1) == 0., bool(surface.fixed()[node]));
}

} // namespace
} // namespace prosup::tests
