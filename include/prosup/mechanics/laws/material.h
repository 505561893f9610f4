#ifndef PROSUP_MECHANICS_MATERIAL_H
#define PROSUP_MECHANICS_MATERIAL_H

#include <deal.II/base/parameter_acceptor.h>
#include <deal.II/base/tensor.h>

#include <map>
#include <string>
#include <vector>

#include "prosup/core/labels.h"

namespace prosup::mechanics {

/// Lame parameters of a hyperelastic material, Pa.
struct LameParameters {
  double mu;
  double lambda;
};

/// lambda = 2 mu nu / (1 - 2 nu).
LameParameters lame_parameters(double shear_modulus, double poisson_ratio);

/// Energy density of the neo-Hookean material, Pa:
///   W = mu/2 (tr C - 3) - mu ln J + lambda/2 (ln J)^2.
/// @throws DivergenceError if det F <= 0.
double neo_hookean_energy(const dealii::Tensor<2, 3>& F, const LameParameters& material);

/// First Piola-Kirchhoff stress P = dW/dF, Pa:
///   P = mu F + (lambda ln J - mu) F^-T,
/// the transpose of the nominal stress of the paper's eq. 2.
/// @throws DivergenceError if det F <= 0.
dealii::Tensor<2, 3> first_piola_kirchhoff_stress(const dealii::Tensor<2, 3>& F,
                                                  const LameParameters& material);

/// The materials that can be chosen by name.
const std::vector<std::string>& material_names();

/// What is not known of the tissues and may be found from images.
struct TissueStiffness {
  double shear_modulus = 357.1; ///< mu of a tissue whose stiffness ratio is 1, Pa
  double poisson_ratio = 0.4;   ///< nu, of all tissues
  double gland_ratio = 1.;      ///< multiplies the stiffness ratio of gland
};

/// The material of the tissues of a body: a stiffness common to all, which
/// the material update changes, and a ratio for each tissue label.
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

  /// Lame parameters for each entry of `tissue_labels`; a single entry if all tissues
  /// are the same material.
  std::vector<LameParameters> parameters_of(const std::vector<unsigned>& tissue_labels,
                                            const TissueStiffness& stiffness) const;

private:
  std::string model_;
  TissueStiffness initial_;
  const Labels& labels_;
  std::map<unsigned, double> stiffness_ratios_{{2, 1.}, {3, 1.}};
};

} // namespace prosup::mechanics

#endif
