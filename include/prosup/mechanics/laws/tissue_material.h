#ifndef PROSUP_MECHANICS_TISSUE_MATERIAL_H
#define PROSUP_MECHANICS_TISSUE_MATERIAL_H

#include <deal.II/base/parameter_acceptor.h>

#include <map>
#include <string>
#include <vector>

#include "prosup/core/labels.h"
#include "prosup/mechanics/laws/material.h"

namespace prosup::mechanics {

/// The properties of the tissues that are not known and may be found from the images.
struct TissueStiffness {
  double shear_modulus = 357.1; ///< mu of a tissue whose stiffness ratio is 1, Pa
  double poisson_ratio = 0.45;  ///< nu, of all tissues
  double gland_ratio = 1.;      ///< multiplies the stiffness ratio of gland
  double skin_stiffness = 0.;   ///< shear modulus times thickness of the skin, Pa mm
};

/// The material of the tissues, section "Material": a law and a Poisson ratio common to all, and
/// for each tissue label the ratio to a common shear modulus, which the material update changes.
class TissueMaterial : public dealii::ParameterAcceptor {
public:
  /// Keeps a reference to `labels`.
  explicit TissueMaterial(const Labels& labels);
  explicit TissueMaterial(Labels&&) = delete;
  void declare_parameters(dealii::ParameterHandler& prm) override;

  /// The stiffness to start with.
  const TissueStiffness& initial() const { return initial_; }
  /// Whether one of the tissues is gland.
  bool has_gland(const std::vector<unsigned>& tissue_labels) const;

  /// The law of 'Material/Model' with its coefficients.
  Law law() const;
  /// For a method that knows a single law. `method` is the subject of the message.
  /// @throws Error if the law is another one.
  void require_model(const std::string& name, const std::string& method) const;

  /// The material of elements with these tissue labels, without skin; uniform if all tissues are
  /// the same.
  /// @throws Error if a label has no stiffness ratio.
  Material material_of(const std::vector<unsigned>& tissue_labels,
                       const TissueStiffness& stiffness) const;

private:
  std::string model_;
  AllLaws laws_;
  TissueStiffness initial_;
  const Labels& labels_;
  std::map<unsigned, double> stiffness_ratios_{{2, 1.}, {3, 1.}};
};

} // namespace prosup::mechanics

#endif
