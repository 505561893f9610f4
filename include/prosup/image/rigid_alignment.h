#ifndef PROSUP_IMAGE_RIGID_ALIGNMENT_H
#define PROSUP_IMAGE_RIGID_ALIGNMENT_H

#include <cstddef>
#include <vector>

#include "prosup/image/rigid_transform.h"

namespace prosup::image {

/// What a rigid alignment may change.
enum class DegreesOfFreedom { translation, rigid };

/// Two surfaces brought together.
struct SurfaceAlignment {
  RigidTransform transform;      ///< from the source to the target
  double distance_before = 0.;   ///< median distance of the surfaces at the start, mm
  double distance_after = 0.;    ///< the same with `transform`, mm
  std::size_t n_points = 0;      ///< of either surface that the other image shows
  std::vector<RigidMotion> open; ///< motions about the centre of `transform` that the surfaces
                                 ///< leave open, of some 1 mm each
};

/// Takes the zero level of `source` to that of `target`, both signed distances
/// (mm), by Gauss-Newton steps from `start` on the distances of each surface's
/// points in the other map, with Cauchy weights; points that the other image does
/// not show do not count. Motions by which the surfaces slide along each other (in
/// a plane, along and about the axis of a cylinder) are left as they are.
/// `start` turns about its own centre if it turns at all.
/// @throws Error if hardly any point of either surface is in the other image.
SurfaceAlignment align_surfaces(const ScalarImage& target, const ScalarImage& source,
                                DegreesOfFreedom freedom, const RigidTransform& start = {});

/// An image and the mask of the part of it that is compared, on any grid.
struct MaskedImage {
  const ScalarImage& image;
  const LabelImage& mask;
};

/// Intensities brought together.
struct IntensityAlignment {
  RigidTransform transform;       ///< from the source to the target
  double information_before = 0.; ///< mutual information at the start, nats
  double information_after = 0.;
};

/// Improves `start` by motions of the span of `open`, maximising the mutual
/// information (Mattes et al., IEEE Trans. Med. Imaging 22, 2003; ITK's
/// implementation) of `target` inside its mask with `source`, coarse to fine. Looks
/// for the largest maximum up to `reach` mm away along each motion, and for the
/// nearest one if that is 0. Intensities are clamped to what occurs in the masks.
/// The result does not depend on the number of threads.
/// @throws Error if the masks or what both images show are too small.
IntensityAlignment align_intensities(const MaskedImage& target, const MaskedImage& source,
                                     const RigidTransform& start,
                                     const std::vector<RigidMotion>& open, double reach);

} // namespace prosup::image

#endif
