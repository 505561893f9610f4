// The law of examples/law, as a host program would add it, at a deformation of 20 %.
#include <gtest/gtest.h>

#include "../../../examples/law/saturating.h"
#include "mechanics/element/point_response.h"

namespace prosup::tests {
namespace {

using namespace prosup::mechanics;

constexpr double I1 = 3.4, log_J = 0.05, mu = 325., step = 1e-5;

TEST(ExampleLaw, StressIsTheDerivativeOfTheEnergy) {
  const OwnLaw law;
  const auto energy = [&](double a, double b) { return law.distortion_energy(mu, a, b); };
  const auto stress = law.distortion_stress(mu, I1, log_J);
  EXPECT_NEAR(stress.a, (energy(I1 + step, log_J) - energy(I1 - step, log_J)) / step, 1e-6 * mu);
  EXPECT_NEAR(stress.b, (energy(I1, log_J + step) - energy(I1, log_J - step)) / (2. * step),
              1e-6 * mu);
}

TEST(ExampleLaw, TangentIsTheDerivativeOfTheStress) {
  const OwnLaw law;
  const auto stress = [&](double a, double b) { return law.distortion_stress(mu, a, b); };
  const auto tangent = law.distortion_tangent(mu, I1, log_J);
  EXPECT_NEAR(tangent.aa, (stress(I1 + step, log_J).a - stress(I1 - step, log_J).a) / step,
              1e-6 * mu);
  EXPECT_NEAR(tangent.ab, (stress(I1, log_J + step).a - stress(I1, log_J - step).a) / (2. * step),
              1e-6 * mu);
  EXPECT_NEAR(tangent.bb, (stress(I1, log_J + step).b - stress(I1, log_J - step).b) / (2. * step),
              1e-6 * mu);
}

// Soft at first, r times as stiff at last.
TEST(ExampleLaw, StiffensByItsRatio) {
  const OwnLaw law;
  EXPECT_DOUBLE_EQ(law.distortion_stress(mu, 3., 0.).a, mu);
  EXPECT_NEAR(law.distortion_stress(mu, 1e4, 0.).a, law.r * mu, 1e-6 * mu);
  EXPECT_NEAR(law.distortion_stress(mu, 3. + law.m, 0.).a, (1. + 0.75 * (law.r - 1.)) * mu,
              1e-9 * mu);
}

} // namespace
} // namespace prosup::tests
