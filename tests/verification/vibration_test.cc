#include <deal.II/base/mpi.h>
#include <gtest/gtest.h>

#include <cmath>

#include "figures.h"
#include "moving_box.h"
#include "strain_energy.h"

namespace prosup::tests {
namespace {

using namespace dealii;
using namespace prosup::mechanics;

// Half of the earth's, mm/s^2: under all of it the swing turns coarse cells inside out.
constexpr double gravity = 0.5 * 9810.;
constexpr unsigned steps_between_looks = 5;

struct EnergyBalance {
  double drift = 0.;      ///< largest |E - E(0)| over the largest kinetic energy
  double deepest = 0.;    ///< largest displacement, mm
  double n_swings = 0.;   ///< of falling and rising again
  double least_step = 1.; ///< smallest critical step in motion over that at rest
};

/// Lets a box drop from rest under half of gravity and swing without damping at
/// 0.9 of the critical step. E = kinetic + strain - work of gravity, and it starts
/// at 0; the kinetic energy is the mean of those half a step before and after.
EnergyBalance swing(ElementType type, unsigned n, unsigned n_steps) {
  MovingBox box({n, n, n}, type, 0.45, jittered);
  NodeVector weight;
  box.body.initialize(weight);
  const std::vector<double> volume = box.forces.nodal_volume();
  for (unsigned node = 0; node < box.body.n_owned_nodes(); ++node)
    weight.local_element(3 * node + 1) = -MovingBox::density * gravity * volume[node];

  CentralDifferences integrator(box.supports, box.forces);
  const StableMass mass = box.mass();
  integrator.set_mass(mass, 0.9);
  weight *= 0.5; // half an impulse from rest to the first half step
  integrator.step(weight, box.displacement);
  weight *= 2.;
  EnergyBalance balance;
  double last_work = 0., largest_kinetic = 0., largest_drift = 0.;
  bool falls = true;
  for (unsigned i = 1; i < n_steps; ++i) {
    if (i % steps_between_looks != 0) {
      integrator.step(weight, box.displacement);
      continue;
    }
    box.displacement.update_ghost_values();
    const double work = weight * box.displacement;
    const double strain =
        strain_energy(box.body, box.material, box.body.vertex_positions(), box.displacement);
    balance.deepest = std::max(balance.deepest, box.displacement.linfty_norm());
    if (i % 100 == 0)
      balance.least_step =
          std::min(balance.least_step, box.mass().critical_step / mass.critical_step);
    const double before = integrator.report().kinetic_energy;
    integrator.step(weight, box.displacement);
    const double kinetic = 0.5 * (before + integrator.report().kinetic_energy);
    largest_kinetic = std::max(largest_kinetic, kinetic);
    largest_drift = std::max(largest_drift, std::abs(kinetic + strain - work));
    balance.n_swings += falls != (work > last_work) ? 0.5 : 0.;
    falls = work > last_work;
    last_work = work;
  }
  balance.drift = largest_drift / largest_kinetic;
  return balance;
}

/// Largest kinetic energy over `n_steps` undamped steps of `safety` times the
/// reported critical step after a rough start of tiny speed, over the first one.
double energy_growth(ElementType type, double safety) {
  MovingBox box({3, 3, 3}, type, 0.45, jittered);
  NodeVector none;
  box.body.initialize(none);
  CentralDifferences integrator(box.supports, box.forces);
  integrator.set_mass(box.mass(), safety);
  for (unsigned i = 0; i < 3 * box.body.n_owned_nodes(); ++i)
    integrator.velocity().local_element(i) =
        1e-3 * std::sin(7.3 * box.body.vertex_positions().local_element(i) + 2. * (i % 3));
  integrator.step(none, box.displacement);
  const double start = integrator.report().kinetic_energy;
  double largest = start;
  for (unsigned i = 0; i < 3000; ++i) {
    integrator.step(none, box.displacement);
    const double energy = integrator.report().kinetic_energy;
    if (!std::isfinite(energy) || energy > 1e6 * start)
      return 1e6;
    largest = std::max(largest, energy);
  }
  return largest / start;
}

TEST(Vibration, EnergyIsKept) {
  for (const ElementType type : all_element_types) {
    const EnergyBalance balance = swing(type, type == ElementType::quadratic ? 2 : 4, 4000);
    constexpr double bound = 0.02;
    EXPECT_LT(balance.drift, bound) << name_of(type);
    EXPECT_GT(balance.deepest, 1.) << name_of(type);
    EXPECT_GT(balance.n_swings, 3.) << name_of(type);
    EXPECT_GT(balance.least_step, 0.9) << name_of(type); // or 0.9 would not be stable
    tell_figure("free vibration at 0.9 of the critical step, nu = 0.45, " + name_of(type) +
                    format(", %.0f swings of up to %.1f mm in 4000 steps", balance.n_swings,
                           balance.deepest),
                "kinetic + strain + potential energy constant",
                format("within %.2f %% of the kinetic energy; critical step in motion not below "
                       "%.2f of that at rest",
                       100. * balance.drift, balance.least_step),
                format("%.0f %%", 100. * bound));
  }
}

TEST(Vibration, StableBelowTheCriticalStepAndUnstableAbove) {
  for (const ElementType type : all_element_types) {
    const double below = energy_growth(type, 0.99), above = energy_growth(type, 1.1);
    EXPECT_LT(below, 6.) << name_of(type);
    EXPECT_GE(above, 1e6) << name_of(type);
    tell_figure("growth of the energy of rough motion in 3000 steps, " + name_of(type),
                "0.99 and 1.1 of the reported critical step",
                format("%.1f and %s", below, above < 1e6 ? format("%.1f", above).c_str() : "> 1e6"),
                "< 6 and > 1e6");
  }
}

} // namespace
} // namespace prosup::tests
