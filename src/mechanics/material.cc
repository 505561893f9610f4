#include "prosup/mechanics/material.h"

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

TissueMaterial::TissueMaterial()
    : ParameterAcceptor("Material"), model_(material_names().front()) {}

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
  prm.add_parameter("Stiffness factors", stiffness_factors_,
                    "Factor on the shear modulus for each tissue label, as 'label: factor'. "
                    "Units: none.",
                    Patterns::Map(Patterns::Integer(0, 255), Patterns::Double(1e-6, 1e6)));
  prm.add_parameter("Gland label", gland_label_,
                    "Label of the tissue whose ratio to the others the material update may find. "
                    "Units: none.",
                    Patterns::Integer(0, 255));
}

bool TissueMaterial::has_gland(const std::vector<unsigned>& tissue_labels) const {
  return std::find(tissue_labels.begin(), tissue_labels.end(), gland_label_) != tissue_labels.end();
}

std::vector<LameParameters>
TissueMaterial::parameters_of(const std::vector<unsigned>& tissue_labels,
                              const TissueStiffness& stiffness) const {
  std::map<unsigned, double> factors = stiffness_factors_;
  if (const auto gland = factors.find(gland_label_); gland != factors.end())
    gland->second *= stiffness.gland_ratio;
  const bool one_material = [&] {
    for (const auto& [label, factor] : factors)
      if (factor != factors.begin()->second)
        return false;
    return true;
  }();
  const auto lame = [&](double factor) {
    return lame_parameters(stiffness.shear_modulus * factor, stiffness.poisson_ratio);
  };
  if (one_material)
    return {lame(factors.empty() ? 1. : factors.begin()->second)};
  std::vector<LameParameters> parameters;
  parameters.reserve(tissue_labels.size());
  for (const unsigned label : tissue_labels) {
    const auto found = factors.find(label);
    if (found == factors.end())
      throw Error(format("Tissue label %u has no entry in 'Material/Stiffness factors'; add "
                         "'%u: factor' there.",
                         label, label));
    parameters.push_back(lame(found->second));
  }
  return parameters;
}

} // namespace prosup::mechanics
