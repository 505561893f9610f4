#ifndef PROSUP_UNLOADING_CHEST_SURFACE_H
#define PROSUP_UNLOADING_CHEST_SURFACE_H

#include "prosup/image/sampling.h"
#include "prosup/image/voxel_image.h"
#include "prosup/mechanics/body/surface.h"

namespace prosup::unloading {

/// The chest wall in a label image: level sets of the smoothed Euclidean distance from
/// its voxels, positive in the tissue (the paper's correction field c = -d n, eq. 10).
/// Smoothing removes the stairs of the voxels, and bumps that the mesh does not resolve, on both
/// of which nodes would get caught. It also
/// shifts the level sets of a chest of radius R by sigma^2/R, which has no effect, since each
/// node stays on its own level set.
class ChestSurface : public mechanics::Surface {
public:
  /// `sigma`: standard deviation of the Gaussian, mm. The surface is known within `margin` mm of
  /// the box from `low` to `high`.
  /// @throws Error if there is no chest voxel in it.
  ChestSurface(const image::LabelImage& labels, unsigned chest_label, double sigma,
               const dealii::Point<3>& low, const dealii::Point<3>& high, double margin);

  double distance(const dealii::Tensor<1, 3>& x, dealii::Tensor<1, 3>& normal) const override;

  /// Gradient of the smoothed distance. Its length is 1 where the chest is smooth and less where
  /// distances from different sides meet within the smoothing: on a sharp crest, between two
  /// sheets, at the edge of one. Where it is short there is no normal to speak of.
  dealii::Tensor<1, 3> gradient(const dealii::Tensor<1, 3>& x) const;

private:
  dealii::Point<3> known_part(const dealii::Tensor<1, 3>& x) const;

  const image::ScalarImage distance_;
  const image::BasicSampler<double> sampler_;
  const double step_; ///< of the differences that give the normal, mm
};

} // namespace prosup::unloading

#endif
