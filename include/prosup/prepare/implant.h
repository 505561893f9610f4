#ifndef PROSUP_PREPARE_IMPLANT_H
#define PROSUP_PREPARE_IMPLANT_H

#include <vector>

#include "prosup/prepare/tissues.h"

namespace prosup::prepare {

/// The largest part of a breast that is no fat and has no fat in it.
struct SolidPart {
  double radius = 0.;     ///< of the largest ball in it, mm
  double volume = 0.;     ///< ml, without what is thinner than 20 mm
  double deviation = 0.;  ///< of its intensities, over the difference of fat and gland
  image::Point<3> centre; ///< of the ball, LPS, mm

  /// Gland has fat in it and edges; the filling of an implant has neither. A dense breast must not
  /// be refused: f > 1/2 alone keeps the deviation of its gland below about 0.3.
  bool is_implant() const { return radius >= 18. && volume >= 80. && deviation <= 0.12; }
};

/// Looks for voxels with the fraction of gland f = (I - mu_0) / (mu_1 - mu_0) above 0.5 (silicone
/// and saline in T1 and CT), and for those with f below -0.5 (in T2, and where fat is suppressed),
/// on voxels of 2 mm. Returns the part with the larger ball.
SolidPart largest_solid_part(const TissueImage& image, const Tissues& tissues);

/// @throws Error if it is an implant.
void require_no_implant(const SolidPart& part);

} // namespace prosup::prepare

#endif
