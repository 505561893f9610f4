#include "scene_maps.h"

#include <algorithm>
#include <cmath>

namespace prosup::registration {

using dealii::Point;
using dealii::Tensor;

namespace {

/// Axes of a picture seen along `front`: the patient's left and up.
struct Axes {
  Tensor<1, 3> left, up;

  explicit Axes(const Tensor<1, 3>& front) {
    // Where the front is the left or right side, some other direction serves.
    Tensor<1, 3> start({1., 0., 0.});
    if (std::abs(front[0]) > 0.9)
      start = Tensor<1, 3>({0., 1., 0.});
    left = start - (start * front) * front;
    left /= left.norm();
    up = dealii::cross_product_3d(left, front);
    if (up[2] < 0.)
      up *= -1.;
  }
};

/// Corners of the box of the grid in a picture.
struct Frame {
  double low[2] = {1e300, 1e300}, high[2] = {-1e300, -1e300};

  Frame(const image::VoxelGrid& grid, const Axes& axes) {
    for (unsigned corner = 0; corner < 8; ++corner) {
      double index[3];
      for (unsigned d = 0; d < 3; ++d)
        index[d] = (corner >> d & 1u) != 0 ? double(grid.size[d]) - 0.5 : -0.5;
      const Point<3> x = grid.physical(index[0], index[1], index[2]);
      const double at[2] = {x * axes.left, x * axes.up};
      for (unsigned d = 0; d < 2; ++d) {
        low[d] = std::min(low[d], at[d]);
        high[d] = std::max(high[d], at[d]);
      }
    }
  }
};

} // namespace

FrontView front_view(const BreastMeasures& breast, const Labels& meaning, const Tensor<1, 3>& front,
                     double edge) {
  const Axes axes(front);
  const image::VoxelGrid& grid = breast.labels.grid;
  const Frame frame(grid, axes);
  FrontView view;
  for (unsigned d = 0; d < 2; ++d)
    view.size[d] = int((frame.high[d] - frame.low[d]) / edge) + 1;
  const std::size_t n = std::size_t(view.size[0]) * std::size_t(view.size[1]);
  view.tissue.assign(n, 0.);
  view.gland.assign(n, 0.);
  view.chest.assign(n, false);
  const auto pixel = [&](const Point<3>& x) {
    const int i = int((x * axes.left - frame.low[0]) / edge);
    const int j = int((x * axes.up - frame.low[1]) / edge);
    return std::size_t(std::clamp(j, 0, view.size[1] - 1)) * std::size_t(view.size[0]) +
           std::size_t(std::clamp(i, 0, view.size[0] - 1));
  };
  const std::array<bool, 256> is_tissue = tissue_table(meaning);
  const double thickness = grid.voxel_volume() / (edge * edge);
  std::size_t v = 0;
  for (std::size_t k = 0; k < grid.size[2]; ++k)
    for (std::size_t j = 0; j < grid.size[1]; ++j)
      for (std::size_t i = 0; i < grid.size[0]; ++i, ++v) {
        const std::uint8_t label = breast.labels.values[v];
        if (label == 0)
          continue;
        const std::size_t p = pixel(grid.physical(double(i), double(j), double(k)));
        if (label == meaning.chest)
          view.chest[p] = true;
        if (is_tissue[label])
          view.tissue[p] += thickness;
        if (label == meaning.gland)
          view.gland[p] += thickness;
      }
  return view;
}

double share_with_chest_behind(const BreastMeasures& breast, const Labels& meaning) {
  if (!(breast.front.norm() > 0.))
    return 0.;
  // Coarser than the voxels, so that each line of sight meets some.
  const auto& spacing = breast.labels.grid.spacing;
  const double edge = 2. * std::max({spacing[0], spacing[1], spacing[2]});
  const FrontView view = front_view(breast, meaning, breast.front, edge);
  std::size_t n_tissue = 0, n_covered = 0;
  for (std::size_t p = 0; p < view.n_pixels(); ++p)
    if (view.tissue[p] > 0.) {
      ++n_tissue;
      n_covered += view.chest[p];
    }
  return n_tissue > 0 ? double(n_covered) / double(n_tissue) : 0.;
}

} // namespace prosup::registration
