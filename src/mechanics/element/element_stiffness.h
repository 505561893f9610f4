#ifndef PROSUP_MECHANICS_ELEMENT_STIFFNESS_H
#define PROSUP_MECHANICS_ELEMENT_STIFFNESS_H

#include <vector>

#include "element_shape.h"
#include "prosup/mechanics/laws/material.h"

namespace prosup::mechanics {

/// J = det dx/dX at a quadrature point; x = X + u.
double point_jacobian(const ElementShape& shape, unsigned q, const unsigned* nodes,
                      const NodeVector& reference, const NodeVector& displacement);

/// What InternalForce documents under similar names, at the local nodes. Collective.
std::vector<double> element_nodal_volume(const Body& body, const NodeVector& reference);
std::vector<double> element_lumped_volume(const Body& body, const NodeVector& reference);
std::vector<double> element_stiffness_bound(const Body& body, const NodeVector& reference,
                                            const NodeVector& displacement,
                                            const Material& material);

} // namespace prosup::mechanics

#endif
