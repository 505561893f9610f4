#include "prosup/mechanics/laws/material.h"

#include <gtest/gtest.h>

#include "prosup/core/error.h"

namespace prosup::tests {
namespace {

using namespace prosup::mechanics;
using dealii::Tensor;

Tensor<2, 3> some_deformation() {
  Tensor<2, 3> F;
  const double values[3][3] = {{1.2, 0.1, -0.2}, {0.05, 0.9, 0.3}, {-0.1, 0.2, 1.1}};
  for (unsigned i = 0; i < 3; ++i)
    for (unsigned j = 0; j < 3; ++j)
      F[i][j] = values[i][j];
  return F;
}

TEST(NeoHookean, StressIsTheDerivativeOfTheEnergy) {
  const LameParameters material = lame_parameters(325., 0.45);
  const Tensor<2, 3> F = some_deformation();
  const Tensor<2, 3> P = first_piola_kirchhoff_stress(F, material);
  const double step = 1e-6;
  for (unsigned i = 0; i < 3; ++i)
    for (unsigned j = 0; j < 3; ++j) {
      Tensor<2, 3> up = F, down = F;
      up[i][j] += step;
      down[i][j] -= step;
      const double slope =
          (neo_hookean_energy(up, material) - neo_hookean_energy(down, material)) / (2. * step);
      EXPECT_NEAR(P[i][j], slope, 1e-6 * material.lambda);
    }
}

TEST(NeoHookean, NoStressAtRestAndLameOfThePaper) {
  const LameParameters material = lame_parameters(357.1, 0.4);
  EXPECT_NEAR(material.lambda, 1428.4, 1e-9);
  Tensor<2, 3> identity;
  for (unsigned i = 0; i < 3; ++i)
    identity[i][i] = 1.;
  EXPECT_NEAR(first_piola_kirchhoff_stress(identity, material).norm(), 0., 1e-12);
}

TEST(NeoHookean, InvertedDeformationIsAnError) {
  Tensor<2, 3> F = some_deformation();
  F[0] *= -1.;
  EXPECT_THROW(neo_hookean_energy(F, {1., 1.}), prosup::DivergenceError);
  EXPECT_THROW(first_piola_kirchhoff_stress(F, {1., 1.}), prosup::DivergenceError);
}

TEST(TissueMaterial, OneMaterialGivesOneEntryAndRatiosGiveOneEach) {
  const prosup::Labels labels;
  TissueMaterial material(labels);
  EXPECT_EQ(material.parameters_of({2, 3, 2}, {100., 0.4, 1.}).size(), 1u);

  dealii::ParameterHandler prm;
  dealii::ParameterAcceptor::declare_all_parameters(prm);
  prm.enter_subsection("Material");
  prm.set("Stiffness ratios", "2: 1, 3: 3");
  prm.leave_subsection();
  dealii::ParameterAcceptor::parse_all_parameters(prm);
  const auto parameters = material.parameters_of({2, 3, 2}, {100., 0.4, 1.});
  ASSERT_EQ(parameters.size(), 3u);
  EXPECT_DOUBLE_EQ(parameters[0].mu, 100.);
  EXPECT_DOUBLE_EQ(parameters[1].mu, 300.);
  EXPECT_TRUE(material.has_gland({2, 3}));
  EXPECT_FALSE(material.has_gland({2, 2}));
  const auto stiffer = material.parameters_of({2, 3}, {100., 0.45, 1.5});
  EXPECT_DOUBLE_EQ(stiffer[0].mu, 100.);
  EXPECT_DOUBLE_EQ(stiffer[1].mu, 450.);
  EXPECT_NEAR(stiffer[1].lambda, 9. * 450., 1e-9);
  EXPECT_THROW(material.parameters_of({4}, {100., 0.4, 1.}), prosup::Error);
}

} // namespace
} // namespace prosup::tests
