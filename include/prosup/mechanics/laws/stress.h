#ifndef PROSUP_MECHANICS_STRESS_H
#define PROSUP_MECHANICS_STRESS_H

#include <deal.II/base/tensor.h>

#include "prosup/mechanics/laws/material.h"

namespace prosup::mechanics {

/// Energy density W of a law at the deformation gradient F, Pa.
/// @throws DivergenceError if det F <= 0.
double energy_density(const dealii::Tensor<2, 3>& F, const LameParameters& parameters,
                      const Law& law = NeoHookean());

/// First Piola-Kirchhoff stress P = dW/dF, Pa; the transpose of the nominal stress of the paper.
/// @throws DivergenceError if det F <= 0.
dealii::Tensor<2, 3> first_piola_kirchhoff_stress(const dealii::Tensor<2, 3>& F,
                                                  const LameParameters& parameters,
                                                  const Law& law = NeoHookean());

} // namespace prosup::mechanics

#endif
