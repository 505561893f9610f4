#ifndef PROSUP_REGISTRATION_QUASI_STATIC_BREAST_H
#define PROSUP_REGISTRATION_QUASI_STATIC_BREAST_H

#include "prosup/core/log.h"
#include "prosup/mechanics/static/quasi_static.h"
#include "prosup/registration/element_breast.h"

namespace prosup::registration {

/// What Newton's method is told besides the breast.
struct QuasiStaticInput {
  const mechanics::QuasiStaticParameters& parameters;
  double contact_stiffness;        ///< of its penalty on surfaces, Pa/mm
  dealii::Tensor<1, 3> body_force; ///< rho g, g/(mm^2 s^2)
  const Log& log;
};

/// What Newton's method finds: both configurations on the first rank of the breast.
struct QuasiStaticSolution {
  mechanics::QuasiStaticResult result;
  mesh::UnloadedMesh mesh;
};

/// As Breast::unload() by Newton's method, without changing the state of the breast but for the
/// reference of its supports. Collective. @throws DivergenceError as QuasiStatic::unload().
QuasiStaticSolution unload_quasi_statically(ElementBreast& breast, const QuasiStaticInput& input);
/// As Breast::load(), likewise.
QuasiStaticSolution load_quasi_statically(ElementBreast& breast, const QuasiStaticInput& input);

} // namespace prosup::registration

#endif
