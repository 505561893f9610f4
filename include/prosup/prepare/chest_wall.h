#ifndef PROSUP_PREPARE_CHEST_WALL_H
#define PROSUP_PREPARE_CHEST_WALL_H

#include <optional>
#include <vector>

#include "prosup/image/voxel_image.h"
#include "prosup/prepare/trunk.h"

namespace prosup::prepare {

/// Whether fat is bright: if d + 0.3 b is above `middle`. d is the cost of the coarse surface with
/// dark fat above that with bright fat; it is not 0 in the middle, because muscle against lung has
/// the sign of bright fat. b = (n- - n+)/(n- + n+), where of the tissue 4 to 60 mm below the skin
/// n- is darker and n+ brighter than the fat below the skin, by more than 0.3 in the logarithm of
/// the intensity; lung and what else is no brighter than air does not count.
struct FatSign {
  bool is_bright = false;
  bool is_doubtful = false; ///< it was not told, and nearer to `middle` than `doubtful`
  static constexpr double weight_of_darker = 0.3, middle = 0.42, doubtful = 0.1;
};

/// Where a wall is not as chests are.
struct Departure {
  double area = 0.;    ///< cm^2
  double largest = 0.; ///< mm, positive to the front
  Point<3> position;   ///< of the largest, LPS, mm
};

/// The front of the chest: of pectoral and serratus muscle, ribs and sternum.
struct ChestWall {
  TrunkSurface surface;
  /// Contrast of fat against what lies behind, of each column: the difference of the logarithms of
  /// the intensities (MR) or of HU/150, positive where it has the sign that is expected; `no_edge`
  /// without a body.
  std::vector<double> edge;
  static constexpr double no_edge = -1e3;
  FatSign fat; ///< as told, or as found
  /// Hills that were taken away.
  Departure bridged;
  /// More than 16 mm from a smooth chest, within 50 degrees of the front and 8 mm from the ends of
  /// the image.
  Departure departure;
};

/// What the chest wall is searched in.
struct ChestImage {
  const image::ScalarImage& image; ///< without bias
  const image::LabelImage& body;
  double air = 0.; ///< median intensity of air
  bool is_ct = false;
};

/// Finds the chest wall as a surface r(theta, z) about the axis of the trunk.
///
/// Coarse, in columns of 1.5 degrees and 3 mm with levels of 1 mm, minimal_surface() of the costs
///   C(r) = -c + m(0, 7) + m(7, 25)/2,  c = s (mean u in (r, r + 7) - mean u in (r - 7, r)),
/// where u is the logarithm of the intensity (HU/150 in CT), s is +1 if fat is bright and -1 if it
/// is dark, c is clamped to -0.3 ... 0.6, and m(a, b) is the mean of how far u is from the fat
/// below the skin in (r + a, r + b), so that muscle, heart and lung cannot lie in front. Fat below
/// the skin is the median (the 35th percentile where it is dark) of u at depths of 4 to 14 mm,
/// smoothed over neighbouring columns. Tissue beyond a gap of air, such as a breast that hangs
/// over, does not count. Gland of the intensity of muscle that lies on the chest makes a hill of
/// this surface. A hill is what stands out from a smooth chest (polynomials of degree 6 in theta
/// and 3 in z, fitted robustly) and is closed all around; if it is 11 mm high or more, the surface
/// is a membrane over its surroundings there. Then fine, in columns of 1 degree and 2 mm with
/// levels of 0.5 mm within 8 mm of the smoothed coarse surface, with means over 3 mm; that follows
/// the edge. If it is not told whether fat is bright, both are tried on the coarse level (FatSign).
/// @throws Error if the body is nowhere thick enough for a chest.
ChestWall find_chest_wall(const ChestImage& image, const TrunkAxis& axis,
                          std::optional<bool> fat_is_bright);

} // namespace prosup::prepare

#endif
