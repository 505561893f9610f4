#include "prosup/mechanics/laws/material.h"

#include <algorithm>
#include <cmath>

#include "prosup/core/error.h"
#include "prosup/core/log.h"
#include "prosup/core/parameters.h"

namespace prosup::mechanics {

using namespace dealii;

namespace {

double checked_determinant(const Tensor<2, 3>& F) {
  const double J = determinant(F);
  if (!(J > 0.))
    throw DivergenceError(format("The deformation gradient has det F = %g; only positive values "
                                 "are allowed, so reduce the load or stiffen the material.",
                                 J));
  return J;
}

} // namespace

LameParameters lame_parameters(double shear_modulus, double poisson_ratio) {
  return {shear_modulus, 2. * shear_modulus * poisson_ratio / (1. - 2. * poisson_ratio)};
}

double neo_hookean_energy(const Tensor<2, 3>& F, const LameParameters& material) {
  const double log_J = std::log(checked_determinant(F));
  return 0.5 * material.mu * (scalar_product(F, F) - 3.) - material.mu * log_J +
         0.5 * material.lambda * log_J * log_J;
}

Tensor<2, 3> first_piola_kirchhoff_stress(const Tensor<2, 3>& F, const LameParameters& material) {
  const double log_J = std::log(checked_determinant(F));
  return material.mu * F + (material.lambda * log_J - material.mu) * transpose(invert(F));
}

const std::vector<std::string>& material_names() {
  static const std::vector<std::string> names{"neo-Hookean"};
  return names;
}

TissueMaterial::TissueMaterial(const Labels& labels)
    : ParameterAcceptor("Material"), model_(material_names().front()), labels_(labels) {}

void TissueMaterial::declare_parameters(ParameterHandler& prm) {
  prm.add_parameter("Model", model_,
                    "Hyperelastic law of all tissues. Allowed: neo-Hookean (paper eq. 2).",
                    one_of(material_names()));
  prm.add_parameter("Shear modulus", initial_.shear_modulus,
                    "mu, the shear modulus to start with, common to all tissues and changed by the "
                    "material update. Units: Pa. The default is the paper's generic material "
                    "(E = 1 kPa, nu = 0.4).",
                    Patterns::Double(1e-3, 1e9));
  prm.add_parameter(
      "Poisson ratio", initial_.poisson_ratio,
      "nu, Poisson's ratio of all tissues; lambda = 2 mu nu / (1 - 2 nu). Units: none. "
      "The default is the paper's generic material. Linear tetrahedra lock towards 0.5.",
      Patterns::Double(0., 0.4999));
  prm.add_parameter("Stiffness ratios", stiffness_ratios_,
                    "Shear modulus of each tissue over 'Shear modulus', as 'label: ratio'. "
                    "Units: none.",
                    Patterns::Map(Patterns::Integer(1, 255), Patterns::Double(1e-6, 1e6)));
}

bool TissueMaterial::has_gland(const std::vector<unsigned>& tissue_labels) const {
  return std::find(tissue_labels.begin(), tissue_labels.end(), labels_.gland) !=
         tissue_labels.end();
}

std::vector<LameParameters>
TissueMaterial::parameters_of(const std::vector<unsigned>& tissue_labels,
                              const TissueStiffness& stiffness) const {
  std::map<unsigned, double> ratios = stiffness_ratios_;
  if (const auto gland = ratios.find(labels_.gland); gland != ratios.end())
    gland->second *= stiffness.gland_ratio;
  const bool one_material = [&] {
    for (const auto& [label, ratio] : ratios)
      if (ratio != ratios.begin()->second)
        return false;
    return true;
  }();
  const auto lame = [&](double ratio) {
    return lame_parameters(stiffness.shear_modulus * ratio, stiffness.poisson_ratio);
  };
  if (one_material)
    return {lame(ratios.empty() ? 1. : ratios.begin()->second)};
  std::vector<LameParameters> parameters;
  parameters.reserve(tissue_labels.size());
  for (const unsigned label : tissue_labels) {
    const auto found = ratios.find(label);
    if (found == ratios.end())
      throw Error(format("Tissue label %u has no entry in 'Material/Stiffness ratios'; add "
                         "'%u: ratio' there.",
                         label, label));
    parameters.push_back(lame(found->second));
  }
  return parameters;
}

} // namespace prosup::mechanics
