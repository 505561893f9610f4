#include "prosup/unloading/chest_surface.h"

#include <algorithm>
#include <cmath>

#include "prosup/core/error.h"
#include "prosup/image/filters.h"
#include "prosup/image/voxel_box.h"

namespace prosup::unloading {

using namespace dealii;
using image::LabelImage;
using image::ScalarImage;

namespace {

constexpr unsigned n_layers = 8; // around the image, where the distance goes on linearly

/// The chest voxels of a part of the label image.
LabelImage chest_mask(const LabelImage& labels, unsigned chest_label, const Point<3>& low,
                      const Point<3>& high, double margin) {
  image::VoxelBox box;
  for (unsigned corner = 0; corner < 8; ++corner) {
    Point<3> x;
    for (unsigned d = 0; d < 3; ++d)
      x[d] = (corner >> d) & 1u ? high[d] + margin : low[d] - margin;
    const Point<3> index = labels.grid.continuous_index(x);
    for (unsigned d = 0; d < 3; ++d) {
      const double last = double(labels.grid.size[d]) - 1.;
      box.begin[d] =
          std::min(box.begin[d], std::size_t(std::clamp(std::floor(index[d]), 0., last)));
      box.end[d] = std::max(box.end[d], std::size_t(std::clamp(std::ceil(index[d]), 0., last)) + 1);
    }
  }
  return image::select_labels(image::part_of(labels, box), {chest_label});
}

ScalarImage smooth_distance(const LabelImage& mask, double sigma) {
  if (std::find(mask.values.begin(), mask.values.end(), 1) == mask.values.end())
    throw Error("There is no chest wall behind the breast for it to slide on; check the labels and "
                "'Labels/Chest', or hold the tissue with 'Case/Chest' = fixed.");
  return image::gaussian_smooth(image::extended(image::signed_distance(mask), n_layers), sigma);
}

} // namespace

ChestSurface::ChestSurface(const LabelImage& labels, unsigned chest_label, double sigma,
                           const Point<3>& low, const Point<3>& high, double margin)
    : distance_(smooth_distance(chest_mask(labels, chest_label, low, high, margin), sigma)),
      sampler_(distance_), step_(std::cbrt(distance_.grid.voxel_volume())) {}

/// The nearest point at which the distance is known.
Point<3> ChestSurface::known_part(const Tensor<1, 3>& x) const {
  const Point<3> index = distance_.grid.continuous_index(Point<3>(x));
  Point<3> inside;
  for (unsigned d = 0; d < 3; ++d) {
    const double last = double(distance_.grid.size[d]) - 1.;
    inside[d] = std::clamp(index[d], 2., std::max(2., last - 2.));
  }
  return distance_.grid.physical(inside[0], inside[1], inside[2]);
}

Tensor<1, 3> ChestSurface::gradient(const Tensor<1, 3>& x) const {
  const Point<3> known = known_part(x);
  Tensor<1, 3> result;
  for (unsigned d = 0; d < 3; ++d) {
    Point<3> ahead = known, behind = known;
    ahead[d] += step_;
    behind[d] -= step_;
    result[d] = (sampler_.value(ahead) - sampler_.value(behind)) / (2. * step_);
  }
  return result;
}

double ChestSurface::distance(const Tensor<1, 3>& x, Tensor<1, 3>& normal) const {
  // Beyond the image the surface goes on straight.
  const Point<3> known = known_part(x);
  normal = gradient(x);
  normal /= std::max(normal.norm(), 1e-6);
  return sampler_.value(known) + normal * (x - known);
}

} // namespace prosup::unloading
