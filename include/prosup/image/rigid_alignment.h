#ifndef PROSUP_IMAGE_RIGID_ALIGNMENT_H
#define PROSUP_IMAGE_RIGID_ALIGNMENT_H

#include <cstddef>
#include <vector>

#include "prosup/image/rigid_transform.h"

namespace prosup::image {

/// The motions that a rigid alignment may use; rigid is translation and rotation.
enum class DegreesOfFreedom { translation, rigid };

/// Result of align_surfaces().
struct SurfaceAlignment {
  RigidTransform transform;      ///< from the source to the target
  double distance_before = 0.;   ///< median distance of the surfaces at the start, mm
  double distance_after = 0.;    ///< median distance with `transform`, mm
  std::size_t n_points = 0;      ///< points of both surfaces that were used
  std::vector<RigidMotion> open; ///< motions about the centre of `transform` that the surfaces
                                 ///< do not determine, of about 1 mm each
};

/// Finds the motion that takes the zero level of `source` to that of `target`. Both are signed
/// distances, mm. Gauss-Newton steps from `start` minimise the distances of the points of each
/// surface in the map of the other, with Cauchy weights. Points outside the other image are
/// not used. Motions that slide the surfaces along each other (in a plane, or along and about
/// the axis of a cylinder) are not determined by these distances; they keep their value in
/// `start`, which may rotate about any centre.
/// @throws Error if hardly any point of either surface is in the other image.
SurfaceAlignment align_surfaces(const ScalarImage& target, const ScalarImage& source,
                                DegreesOfFreedom freedom, const RigidTransform& start = {});

/// An image and the mask of its part that is compared. The grids may differ.
struct MaskedImage {
  const ScalarImage& image;
  const LabelImage& mask;
};

/// Result of align_intensities().
struct IntensityAlignment {
  RigidTransform transform;       ///< from the source to the target
  double information_before = 0.; ///< mutual information at the start, nats
  double information_after = 0.;  ///< mutual information with `transform`, nats
};

/// Improves `start` by linear combinations of the motions in `open`. Maximises the mutual
/// information (Mattes et al., IEEE Trans. Med. Imaging 22, 2003; implementation of ITK) of
/// `target` within its mask with `source`, from coarse to fine images. Searches for the global
/// maximum up to `search_distance` mm along each motion, or if that is 0 for the nearest
/// maximum. Intensities are clamped to the range within the masks. The result does not depend
/// on the number of threads.
/// @throws Error if the masks or their overlap are too small.
IntensityAlignment align_intensities(const MaskedImage& target, const MaskedImage& source,
                                     const RigidTransform& start,
                                     const std::vector<RigidMotion>& open, double search_distance);

} // namespace prosup::image

#endif
