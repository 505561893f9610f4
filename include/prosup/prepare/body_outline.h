#ifndef PROSUP_PREPARE_BODY_OUTLINE_H
#define PROSUP_PREPARE_BODY_OUTLINE_H

#include "prosup/image/voxel_image.h"

namespace prosup::prepare {

/// The body in an image.
struct Outline {
  image::LabelImage body; ///< 1 in the body with all that it encloses, such as the lungs
  double air = 0.;        ///< median intensity of the air in front of it
  double threshold = 0.;  ///< intensity between noise and tissue
};

/// Tells the body from the air in front of it.
///
/// The threshold between noise and tissue is -500 HU in CT, and in MR that of Otsu (IEEE Trans.
/// Syst. Man Cybern. 9, 1979) for the logarithm of the intensities, or a tenth of the largest
/// intensity within 25 mm, if that is more, which keeps ghosts out. In MR, what lies in front of
/// the steepest edge of the body is air, however bright: body_within_edges(). Air is what is seen
/// from the front of the image (from anterior, -y) before the largest part above the threshold, and
/// what can be reached from there through passages wider than 10 mm, 40 mm to the side at most; so
/// lungs and heart belong to the body even if the image ends in them. In MR the skin then moves
/// inward to the middle of its blurred edge, whatever the sensitivity of the coil is there: half of
/// the largest intensity within 2 mm if that is skin, and a quarter if it is fat, since skin is
/// then about half as bright. It is skin if the median of those peaks is more than 1.35 times that
/// of the intensities 4 to 8 mm below the edge: in trials 1.6 to 2.0 in three images with
/// suppressed fat, 1.0 to 1.2 in nine with bright fat. Ghosts that are darker than a quarter of the
/// largest within 8 mm are air.
/// @throws Error if there is no body or no air in front of it.
Outline find_outline(const image::ScalarImage& image, bool is_ct);

} // namespace prosup::prepare

#endif
