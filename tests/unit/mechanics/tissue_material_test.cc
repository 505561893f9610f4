#include "prosup/mechanics/laws/tissue_material.h"

#include <deal.II/base/parameter_handler.h>
#include <gtest/gtest.h>

#include <functional>

#include "expect_error.h"
#include "prosup/core/error.h"

namespace prosup::tests {
namespace {

using namespace prosup::mechanics;

void parse(const std::function<void(dealii::ParameterHandler&)>& set) {
  dealii::ParameterHandler prm;
  dealii::ParameterAcceptor::declare_all_parameters(prm);
  prm.enter_subsection("Material");
  set(prm);
  prm.leave_subsection();
  dealii::ParameterAcceptor::parse_all_parameters(prm);
}

TEST(TissueMaterial, OneMaterialGivesOneEntryAndRatiosGiveOneEach) {
  const Labels labels;
  TissueMaterial material(labels);
  EXPECT_EQ(material.material_of({2, 3, 2}, {100., 0.4, 1.}).size(), 1u);

  parse([](auto& prm) { prm.set("Stiffness ratios", "2: 1, 3: 3"); });
  const Material parameters = material.material_of({2, 3, 2}, {100., 0.4, 1.});
  ASSERT_EQ(parameters.size(), 3u);
  EXPECT_DOUBLE_EQ(parameters[0].mu, 100.);
  EXPECT_DOUBLE_EQ(parameters[1].mu, 300.);
  EXPECT_TRUE(material.has_gland({2, 3}));
  EXPECT_FALSE(material.has_gland({2, 2}));
  const Material stiffer = material.material_of({2, 3}, {100., 0.45, 1.5});
  EXPECT_DOUBLE_EQ(stiffer[0].mu, 100.);
  EXPECT_DOUBLE_EQ(stiffer[1].mu, 450.);
  EXPECT_NEAR(stiffer[1].lambda, 9. * 450., 1e-9);
  EXPECT_THROW(material.material_of({4}, {100., 0.4, 1.}), Error);
}

TEST(TissueMaterial, ModelChoosesTheLawAndItsSectionTheCoefficients) {
  const Labels labels;
  TissueMaterial material(labels);
  EXPECT_EQ(name_of(material.law()), "neo-hookean");
  parse([](auto& prm) {
    prm.set("Model", "yeoh");
    prm.enter_subsection("Yeoh");
    prm.set("Quadratic coefficient", 2.5);
    prm.set("Cubic coefficient", 0.5);
    prm.leave_subsection();
  });
  for (const std::vector<unsigned>& tissues : {std::vector<unsigned>{2}, {2, 3}}) {
    const Law law = material.material_of(tissues, material.initial()).law();
    ASSERT_EQ(name_of(law), "yeoh");
    EXPECT_DOUBLE_EQ(std::get<Yeoh>(law).c2, 2.5);
    EXPECT_DOUBLE_EQ(std::get<Yeoh>(law).c3, 0.5);
  }
}

TEST(TissueMaterial, MethodsOfOneLawRefuseOthers) {
  const Labels labels;
  TissueMaterial material(labels);
  material.require_model("neo-hookean", "the finite-difference method");
  parse([](auto& prm) { prm.set("Model", "yeoh"); });
  expect_error([&] { material.require_model("neo-hookean", "the finite-difference method"); },
               {"Material/Model", "yeoh", "neo-hookean", "finite-difference"});
}

} // namespace
} // namespace prosup::tests
