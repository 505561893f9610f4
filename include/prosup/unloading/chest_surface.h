#ifndef PROSUP_UNLOADING_CHEST_SURFACE_H
#define PROSUP_UNLOADING_CHEST_SURFACE_H

#include "prosup/image/sampling.h"
#include "prosup/image/voxel_image.h"
#include "prosup/mechanics/body/surface.h"

namespace prosup::unloading {

/// The surface of the chest wall in a label image: level sets of the smoothed
/// Euclidean distance to its voxels, positive in the tissue (paper's correction
/// field c = -d n, eq. 10). The stairs of the voxels are smoothed away, so that
/// nodes do not catch on them; on a chest of radius R the level sets move by
/// sigma^2/R in parallel, which does not matter since each node keeps its own.
class ChestSurface : public mechanics::Surface {
public:
  /// `sigma_voxels`: standard deviation of the Gaussian, in cube roots of the
  /// volume of a voxel. The surface is needed within `margin` mm of the box from
  /// `low` to `high`. @throws Error if there is no chest voxel there.
  ChestSurface(const image::LabelImage& labels, unsigned chest_label, double sigma_voxels,
               const dealii::Point<3>& low, const dealii::Point<3>& high, double margin);

  double distance(const dealii::Tensor<1, 3>& x, dealii::Tensor<1, 3>& normal) const override;

private:
  const image::ScalarImage distance_;
  const image::BasicSampler<double> sampler_;
  const double step_; ///< of the differences that give the normal, mm
};

} // namespace prosup::unloading

#endif
