#include <gtest/gtest.h>

#include <cmath>

#include "all_laws.h"
#include "mechanics/element/point_response.h"
#include "prosup/core/error.h"
#include "prosup/mechanics/laws/stress.h"

namespace prosup::tests {
namespace {

using namespace dealii;
using namespace prosup::mechanics;

const LameParameters lame = lame_parameters(325., 0.45);

Tensor<2, 3> matrix(const double (&values)[3][3]) {
  Tensor<2, 3> result;
  for (unsigned i = 0; i < 3; ++i)
    for (unsigned j = 0; j < 3; ++j)
      result[i][j] = values[i][j];
  return result;
}

const Tensor<2, 3> identity = matrix({{1., 0., 0.}, {0., 1., 0.}, {0., 0., 1.}});
const Tensor<2, 3> deformed = matrix({{1.2, 0.1, -0.2}, {0.05, 0.9, 0.3}, {-0.1, 0.2, 1.1}});

/// dP for dF, from the coefficients of a law.
Tensor<2, 3> stress_change(const Law& law, const Tensor<2, 3>& F, const Tensor<2, 3>& dF) {
  const auto [stress, tangent] =
      std::visit([&](const auto& of) { return response(of, lame, F, determinant(F)); }, law);
  const Tensor<2, 3> G = transpose(invert(F));
  const double along_F = scalar_product(F, dF), along_G = scalar_product(G, dF);
  return stress.a * dF - stress.b * (G * transpose(dF) * G) +
         (tangent.aa * along_F + tangent.ab * along_G) * F +
         (tangent.ab * along_F + tangent.bb * along_G) * G;
}

class EveryLaw : public ::testing::TestWithParam<unsigned> {
protected:
  const Law law = all_laws()[GetParam()];
};

TEST_P(EveryLaw, StressIsTheDerivativeOfTheEnergy) {
  const Tensor<2, 3> P = first_piola_kirchhoff_stress(deformed, lame, law);
  constexpr double step = 1e-6;
  for (unsigned i = 0; i < 3; ++i)
    for (unsigned j = 0; j < 3; ++j) {
      Tensor<2, 3> up = deformed, down = deformed;
      up[i][j] += step;
      down[i][j] -= step;
      const double slope =
          (energy_density(up, lame, law) - energy_density(down, lame, law)) / (2. * step);
      EXPECT_NEAR(P[i][j], slope, 1e-6 * lame.lambda);
    }
}

TEST_P(EveryLaw, TangentIsTheDerivativeOfTheStress) {
  constexpr double step = 1e-6;
  for (unsigned i = 0; i < 3; ++i)
    for (unsigned j = 0; j < 3; ++j) {
      Tensor<2, 3> dF;
      dF[i][j] = 1.;
      const Tensor<2, 3> expected =
          (first_piola_kirchhoff_stress(deformed + step * dF, lame, law) -
           first_piola_kirchhoff_stress(deformed - step * dF, lame, law)) /
          (2. * step);
      EXPECT_LT((stress_change(law, deformed, dF) - expected).norm(), 1e-6 * lame.lambda);
    }
}

TEST_P(EveryLaw, HasNoStressAtRestAndTheModuliOfSmallStrains) {
  EXPECT_NEAR(first_piola_kirchhoff_stress(identity, lame, law).norm(), 0., 1e-12);
  EXPECT_NEAR(energy_density(identity, lame, law), 0., 1e-12);
  const Tensor<2, 3> strain = matrix({{0.3, 0.2, 0.}, {0.2, -0.1, 0.4}, {0., 0.4, 0.5}});
  const Tensor<2, 3> hooke = 2. * lame.mu * strain + lame.lambda * trace(strain) * identity;
  EXPECT_LT((stress_change(law, identity, strain) - hooke).norm(), 1e-11 * lame.lambda);
}

TEST_P(EveryLaw, DoesNotFeelRotations) {
  const double c = std::cos(0.7), s = std::sin(0.7);
  const Tensor<2, 3> R = matrix({{c, -s, 0.}, {s, c, 0.}, {0., 0., 1.}});
  const Tensor<2, 3> P = first_piola_kirchhoff_stress(deformed, lame, law);
  EXPECT_LT((first_piola_kirchhoff_stress(R * deformed, lame, law) - R * P).norm(),
            1e-12 * P.norm());
  EXPECT_NEAR(first_piola_kirchhoff_stress(R, lame, law).norm(), 0., 1e-11);
}

TEST_P(EveryLaw, ScalesWithTheModuli) {
  const LameParameters twice{2. * lame.mu, 2. * lame.lambda};
  EXPECT_NEAR(energy_density(deformed, twice, law), 2. * energy_density(deformed, lame, law),
              1e-10);
}

TEST_P(EveryLaw, InvertedDeformationIsAnError) {
  Tensor<2, 3> F = deformed;
  F[0] *= -1.;
  EXPECT_THROW(energy_density(F, {1., 1.}, law), DivergenceError);
  EXPECT_THROW(first_piola_kirchhoff_stress(F, {1., 1.}, law), DivergenceError);
}

INSTANTIATE_TEST_SUITE_P(Laws, EveryLaw, ::testing::Range(0u, unsigned(law_names().size())),
                         [](const auto& info) { return "law" + std::to_string(info.param); });

TEST(Yeoh, WithoutCoefficientsIsNeoHookeanAndWithThemStiffer) {
  const double soft = energy_density(deformed, lame);
  EXPECT_NEAR(energy_density(deformed, lame, Yeoh{{}, 0., 0.}), soft, 1e-12 * soft);
  // The polynomial itself, where the volume does not change.
  const double g = 0.8;
  const Tensor<2, 3> shear = matrix({{1., g, 0.}, {0., 1., 0.}, {0., 0., 1.}});
  const double k = g * g; // I1 - 3
  EXPECT_NEAR(energy_density(shear, lame, Yeoh{{}, 2., 3.}),
              0.5 * lame.mu * (k + 2. * k * k + 3. * k * k * k), 1e-10);
}

TEST(LameParameters, AreThoseOfThePaper) {
  EXPECT_NEAR(lame_parameters(357.1, 0.4).lambda, 1428.4, 1e-9);
}

} // namespace
} // namespace prosup::tests
