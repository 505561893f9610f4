#ifndef PROSUP_SRC_REGISTRATION_STEP_LIMIT_H
#define PROSUP_SRC_REGISTRATION_STEP_LIMIT_H

#include "prosup/mechanics/body/body.h"

namespace prosup::registration {

/// Range of J = det dx/dX that image forces may not leave.
struct JacobianBounds {
  double smallest, largest;
};

/// Smallest J of the cells of this rank; 0 if one is inverted.
double smallest_jacobian_of(const mechanics::Body& body, const mechanics::NodeVector& unloaded);

/// Shortens a step of the unloaded positions at the nodes of those cells whose J would leave the
/// bounds or, if it is beyond them already, would go farther. A single cell must not hold up the
/// whole breast, and the linear elastic energy of the image forces does not keep a cell from
/// getting flat: a cell in the edge between skin and cut plane has a single free node, which the
/// image pulls along the skin. Needs ghosts of `unloaded`; the step's are set. Collective on the
/// body.
void limit_step(const mechanics::Body& body, const mechanics::NodeVector& unloaded,
                const JacobianBounds& bounds, mechanics::NodeVector& step);

} // namespace prosup::registration

#endif
