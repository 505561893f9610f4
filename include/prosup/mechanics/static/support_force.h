#ifndef PROSUP_MECHANICS_SUPPORT_FORCE_H
#define PROSUP_MECHANICS_SUPPORT_FORCE_H

#include <memory>

#include "prosup/mechanics/body/nodal_force.h"
#include "prosup/mechanics/body/supports.h"

namespace prosup::mechanics {

/// The springs and contact surfaces of supports as forces for Newton's method (QuasiStatic).
/// Contact is a penalty of `contact_stiffness` k (Pa/mm) on areas A of the loaded configuration,
///   f = -A k (d(x) - d(X)) n(x),
/// d being the distance from the surface and n its normal. Keeps a reference to `supports`, whose
/// set_reference() gives the areas of the springs. Collective.
std::unique_ptr<NodalForce> support_force(const Supports& supports, double contact_stiffness);

} // namespace prosup::mechanics

#endif
