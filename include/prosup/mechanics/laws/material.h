#ifndef PROSUP_MECHANICS_MATERIAL_H
#define PROSUP_MECHANICS_MATERIAL_H

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

/// The material of a body: a law, and its Lame parameters for all elements or for each one.
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
  /// Parameters of an element.
  const LameParameters& operator[](std::size_t element) const {
    return parameters_[is_uniform() ? 0 : element];
  }

private:
  Law law_;
  std::vector<LameParameters> parameters_;
};

} // namespace prosup::mechanics

#endif
