#include "prosup/mechanics/laws/stress.h"

#include <cmath>

#include "prosup/core/error.h"
#include "prosup/core/log.h"

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

double energy_density(const Tensor<2, 3>& F, const LameParameters& parameters, const Law& law) {
  const double log_J = std::log(checked_determinant(F)), I1 = scalar_product(F, F);
  return std::visit(
      [&](const auto& of) {
        return of.distortion_energy(parameters.mu, I1, log_J) +
               of.volume_energy(parameters.lambda, log_J);
      },
      law);
}

Tensor<2, 3> first_piola_kirchhoff_stress(const Tensor<2, 3>& F, const LameParameters& parameters,
                                          const Law& law) {
  const double log_J = std::log(checked_determinant(F)), I1 = scalar_product(F, F);
  return std::visit(
      [&](const auto& of) {
        const auto [a, b] = of.distortion_stress(parameters.mu, I1, log_J);
        return a * F + (b + of.volume_slope(parameters.lambda, log_J)) * transpose(invert(F));
      },
      law);
}

} // namespace prosup::mechanics
