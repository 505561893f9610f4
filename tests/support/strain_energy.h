#ifndef PROSUP_TESTS_STRAIN_ENERGY_H
#define PROSUP_TESTS_STRAIN_ENERGY_H

#include "prosup/mechanics/body/body.h"
#include "prosup/mechanics/laws/material.h"

namespace prosup::tests {

/// Energy of which the internal forces of a body are the derivative (see
/// InternalForce), with deal.II's own shape functions, g mm^2/s^2. `reference`
/// and `u` with ghosts.
double strain_energy(const mechanics::Body& body, const mechanics::Material& material,
                     const mechanics::NodeVector& reference, const mechanics::NodeVector& u);

} // namespace prosup::tests

#endif
