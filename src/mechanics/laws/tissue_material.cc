#include "prosup/mechanics/laws/tissue_material.h"

#include <algorithm>
#include <utility>

#include "prosup/core/error.h"
#include "prosup/core/log.h"
#include "prosup/core/parameters.h"

namespace prosup::mechanics {

using namespace dealii;

namespace {

/// Declares the parameters of a law in a section of its own, if it has any.
template <typename L>
void declare_coefficients(L& law, ParameterHandler& prm) {
  const std::string section = L::section;
  if (section.empty())
    return;
  prm.enter_subsection(section);
  law.coefficients(
      [&](const char* name, double& value, double minimum, double maximum, const char* text) {
        prm.add_parameter(name, value, text, Patterns::Double(minimum, maximum));
      });
  prm.leave_subsection();
}

} // namespace

TissueMaterial::TissueMaterial(const Labels& labels)
    : ParameterAcceptor("Material"), model_(law_names().front()), labels_(labels) {}

void TissueMaterial::declare_parameters(ParameterHandler& prm) {
  prm.add_parameter("Model", model_,
                    "Hyperelastic law of all tissues. neo-hookean: eq. 2 of the paper. yeoh: a "
                    "polynomial that stiffens with stretch, see 'Material/Yeoh'; not available for "
                    "finite differences.",
                    one_of(law_names()));
  prm.add_parameter("Shear modulus", initial_.shear_modulus,
                    "mu, common to all tissues. The material update starts from this value. "
                    "Units: Pa. The default is that of the paper's generic material.",
                    Patterns::Double(1e-3, 1e9));
  prm.add_parameter(
      "Poisson ratio", initial_.poisson_ratio,
      "nu, common to all tissues; lambda = 2 mu nu / (1 - 2 nu). Units: none. With the 0.40 of the "
      "paper's generic material a real breast changes its volume by 5 to 12 percent from prone to "
      "supine, with 0.45 by half of that. Linear tetrahedra lock as nu approaches 0.5.",
      Patterns::Double(0., 0.4999));
  prm.add_parameter(
      "Skin stiffness", initial_.skin_stiffness,
      "s = mu_s h, shear modulus of the skin times its thickness: a neo-Hookean "
      "membrane on the surface, which wrinkles under pressure. 0: no skin. With fe only. "
      "'Material update/Properties' can name it among what is searched. Units: Pa mm.",
      Patterns::Double(0., 1e9));
  prm.add_parameter("Stiffness ratios", stiffness_ratios_,
                    "Shear modulus of each tissue over 'Shear modulus', as 'label: ratio'. "
                    "Units: none.",
                    Patterns::Map(Patterns::Integer(1, 255), Patterns::Double(1e-6, 1e6)));
  std::apply([&](auto&... law) { (declare_coefficients(law, prm), ...); }, laws_);
}

Law TissueMaterial::law() const {
  return std::apply(
      [&](const auto& first, const auto&... others) {
        Law chosen = first;
        ((others.name == model_ ? void(chosen = others) : void()), ...);
        return chosen;
      },
      laws_);
}

void TissueMaterial::require_model(const std::string& name, const std::string& method) const {
  if (model_ != name)
    throw Error("'Material/Model' is '" + model_ + "', but " + method + " allows only '" + name +
                "'; choose this model or another method.");
}

bool TissueMaterial::has_gland(const std::vector<unsigned>& tissue_labels) const {
  return std::find(tissue_labels.begin(), tissue_labels.end(), labels_.gland) !=
         tissue_labels.end();
}

Material TissueMaterial::material_of(const std::vector<unsigned>& tissue_labels,
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
    return {lame(ratios.empty() ? 1. : ratios.begin()->second), law()};
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
  return {std::move(parameters), law()};
}

} // namespace prosup::mechanics
