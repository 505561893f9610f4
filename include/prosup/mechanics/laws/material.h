#ifndef PROSUP_MECHANICS_MATERIAL_H
#define PROSUP_MECHANICS_MATERIAL_H

#include <deal.II/base/types.h>

#include <utility>
#include <vector>

#include "prosup/mechanics/laws/law.h"

namespace prosup::mechanics {

/// Lame parameters of small strains, Pa.
struct LameParameters {
  double mu;
  double lambda;
};

/// lambda = 2 mu nu / (1 - 2 nu).
LameParameters lame_parameters(double shear_modulus, double poisson_ratio);

/// A skin on the boundary faces with this id: an incompressible neo-Hookean membrane that nothing
/// bends.
struct Skin {
  dealii::types::boundary_id boundary = 0;
  double stiffness = 0.; ///< shear modulus times thickness, Pa mm; 0 if there is no skin
};

/// The material of a body: a law, its Lame parameters for all elements or for each one, and its
/// skin.
class Material {
public:
  /// No material yet.
  Material() = default;
  Material(const LameParameters& of_all, const Law& law = NeoHookean())
      : law_(law), parameters_{of_all} {}
  /// One entry for each element that the rank owns, in the order of Body, or a single one.
  Material(std::vector<LameParameters> parameters, const Law& law = NeoHookean())
      : law_(law), parameters_(std::move(parameters)) {}

  const Law& law() const { return law_; }
  bool is_empty() const { return parameters_.empty(); }
  /// Whether all elements have the same parameters.
  bool is_uniform() const { return parameters_.size() == 1; }
  /// Number of entries.
  std::size_t size() const { return parameters_.size(); }
  const Skin& skin() const { return skin_; }
  void set_skin(const Skin& skin) { skin_ = skin; }
  /// Parameters of an element.
  const LameParameters& operator[](std::size_t element) const {
    return parameters_[is_uniform() ? 0 : element];
  }

private:
  Law law_;
  std::vector<LameParameters> parameters_;
  Skin skin_;
};

} // namespace prosup::mechanics

#endif
