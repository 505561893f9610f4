#ifndef PROSUP_MESH_LEVEL_SET_H
#define PROSUP_MESH_LEVEL_SET_H

#include <array>

#include "prosup/image/sampling.h"
#include "prosup/image/voxel_image.h"

namespace prosup::mesh {

/// Smooth signed distance (mm, negative inside) to the boundary of a mask, cut
/// to the surroundings of the mask, in the frame of the grid: mm along the grid
/// axes, centre of voxel 0 of the mask at the origin. The border of the image is
/// no boundary, so that the level sets reach it at their own angle.
class LevelSet {
public:
  /// `sigma_mm` is the standard deviation of the Gaussian that smooths the
  /// stairs of the voxels. The mask must not be empty.
  LevelSet(const image::LabelImage& mask, double sigma_mm);
  LevelSet(const LevelSet&) = delete;
  LevelSet& operator=(const LevelSet&) = delete;

  double value(const image::Point<3>& x) const { return sampler_.value(x); }

  double value_and_gradient(const image::Point<3>& x, image::Tensor<1, 3>& gradient) const {
    return sampler_.value_and_gradient(x, gradient);
  }

  /// The box that holds the mask, mm: where the mask touches the border of the
  /// image it ends at the outer faces of the voxels, elsewhere outside the mask.
  const std::array<image::Point<3>, 2>& box() const { return box_; }

  /// Standard deviation of the smoothing, mm.
  double sigma() const { return sigma_; }

  /// Volume of the mask, mm^3.
  double mask_volume() const { return mask_volume_; }

private:
  image::ScalarImage distance_;
  image::Sampler sampler_;
  std::array<image::Point<3>, 2> box_;
  double sigma_;
  double mask_volume_ = 0.;
};

} // namespace prosup::mesh

#endif
