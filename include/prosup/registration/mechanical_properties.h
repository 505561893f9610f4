#ifndef PROSUP_REGISTRATION_MECHANICAL_PROPERTIES_H
#define PROSUP_REGISTRATION_MECHANICAL_PROPERTIES_H

#include "prosup/mechanics/laws/tissue_material.h"

namespace prosup::registration {

/// Mechanical properties that differ from patient to patient, and that MaterialUpdate can find from
/// the images.
struct MechanicalProperties {
  mechanics::TissueStiffness tissue;
  /// Of the springs between breast and chest wall, Pa/mm; 0 if there are none.
  double chest_stiffness = 0.;
};

} // namespace prosup::registration

#endif
