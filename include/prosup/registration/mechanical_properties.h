#ifndef PROSUP_REGISTRATION_MECHANICAL_PROPERTIES_H
#define PROSUP_REGISTRATION_MECHANICAL_PROPERTIES_H

#include <deal.II/base/tensor.h>

#include <array>

#include "prosup/core/position.h"
#include "prosup/mechanics/laws/tissue_material.h"

namespace prosup::registration {

/// By what angles the gravity of supine deviates from the direction given, rad: a patient rarely
/// lies as flat in one scanner as in the other, and its axes are not those of the chest. Only the
/// difference between both states can be told from images: tilted alike, both unloaded shapes
/// move alike.
struct Tilt {
  double left = 0.;     ///< towards the patient's left
  double superior = 0.; ///< towards the head

  /// Both angles in degrees.
  std::array<double, 2> degrees() const;
};

/// `gravity` turned by these angles, as a unit vector: g + tan(left) a + tan(superior) b,
/// normalised, with unit vectors a, b perpendicular to g, a as far to the left as possible.
dealii::Tensor<1, 3> tilted(const dealii::Tensor<1, 3>& gravity, const Tilt& tilt);

/// What differs from patient to patient and scan to scan and decides how a breast hangs, and what
/// MaterialUpdate can find from the images.
struct MechanicalProperties {
  mechanics::TissueStiffness tissue;
  /// Of the springs between breast and chest wall, Pa/mm; 0 if there are none.
  double chest_stiffness = 0.;
  /// rho: where the chest faces sideways these springs are as many times as stiff as in front,
  /// k rho^|n_x| with the unit normal n of the chest in LPS.
  double lateral_chest_ratio = 1.;
  /// Of the springs on cut planes, Pa/mm; 0 if there are none. The fields of view of both scans
  /// differ, and so does what lies beyond.
  PerPosition<double> cut_plane_stiffness{};
  Tilt tilt{};
};

} // namespace prosup::registration

#endif
