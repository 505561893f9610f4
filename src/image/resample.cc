#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "prosup/core/error.h"
#include "prosup/core/log.h"
#include "prosup/image/filters.h"
#include "prosup/image/sampling.h"
#include "smoothing.h"

namespace prosup::image {

namespace {

VoxelGrid isotropic_grid(const VoxelGrid& grid, double spacing_mm) {
  if (!(spacing_mm > 0.) || !std::isfinite(spacing_mm))
    throw Error(format("The spacing to resample to is %g mm, but must be positive.", spacing_mm));
  VoxelGrid isotropic = grid;
  double first_centre[3];
  for (unsigned d = 0; d < 3; ++d) {
    const double extent = double(grid.size[d]) * grid.spacing[d];
    const double n_voxels = std::max(1., std::round(extent / spacing_mm));
    isotropic.size[d] = static_cast<std::size_t>(n_voxels);
    isotropic.spacing[d] = extent / n_voxels;
    first_centre[d] = -0.5 + 0.5 * isotropic.spacing[d] / grid.spacing[d];
  }
  isotropic.origin = grid.physical(first_centre[0], first_centre[1], first_centre[2]);
  return isotropic;
}

/// Width of the Gaussian that widens a point-spread function of full width at
/// half maximum `from` to `to`; zero if that is no wider.
double widening_sigma(double from, double to) {
  if (to <= from * (1. + 1e-6))
    return 0.;
  const double fwhm_per_sigma = 2. * std::sqrt(2. * std::log(2.));
  return std::sqrt(to * to - from * from) / fwhm_per_sigma;
}

/// Calls function(voxel, X) for each voxel of `grid` and its centre X, mm.
template <typename Function>
void for_each_voxel(const VoxelGrid& grid, const Function& function) {
  std::size_t voxel = 0;
  for (std::size_t k = 0; k < grid.size[2]; ++k)
    for (std::size_t j = 0; j < grid.size[1]; ++j)
      for (std::size_t i = 0; i < grid.size[0]; ++i)
        function(voxel++, grid.physical(double(i), double(j), double(k)));
}

ScalarImage sample(const ScalarImage& image, const VoxelGrid& grid) {
  const Sampler sampler(image);
  ScalarImage result(grid);
  for_each_voxel(
      grid, [&](std::size_t voxel, const Point<3>& X) { result.values[voxel] = sampler.value(X); });
  return result;
}

} // namespace

ScalarImage resample_isotropic(const ScalarImage& image, double spacing_mm) {
  const VoxelGrid grid = isotropic_grid(image.grid, spacing_mm);
  if (grid.coincides_with(image.grid, 1e-6))
    return image;
  Tensor<1, 3> sigma;
  for (unsigned d = 0; d < 3; ++d)
    sigma[d] = widening_sigma(image.grid.spacing[d], grid.spacing[d]);
  return sample(smooth_along_axes(image, sigma), grid);
}

LabelImage resample_isotropic(const LabelImage& labels, double spacing_mm) {
  const VoxelGrid grid = isotropic_grid(labels.grid, spacing_mm);
  if (grid.coincides_with(labels.grid, 1e-6))
    return labels;
  LabelImage result(grid, labels.values.at(0));
  if (std::all_of(labels.values.begin(), labels.values.end(),
                  [&](std::uint8_t label) { return label == labels.values[0]; }))
    return result;
  std::array<bool, 256> occurs{};
  for (const std::uint8_t label : labels.values)
    occurs[label] = true;
  ScalarImage smallest(grid, std::numeric_limits<float>::infinity());
  for (unsigned label = 0; label < occurs.size(); ++label) {
    if (!occurs[label])
      continue;
    const ScalarImage distance = sample(signed_distance(select_labels(labels, {label})), grid);
    for (std::size_t v = 0; v < distance.values.size(); ++v)
      if (distance.values[v] < smallest.values[v]) {
        smallest.values[v] = distance.values[v];
        result.values[v] = static_cast<std::uint8_t>(label);
      }
  }
  return result;
}

ScalarImage warp(const ScalarImage& loaded, const VectorImage& displacement, float outside) {
  const Sampler sampler(loaded);
  ScalarImage result(displacement.grid);
  for_each_voxel(displacement.grid, [&](std::size_t voxel, const Point<3>& X) {
    const std::array<float, 3>& u = displacement.values[voxel];
    const Point<3> x(X[0] + u[0], X[1] + u[1], X[2] + u[2]);
    result.values[voxel] = sampler.inside(x) ? sampler.value(x) : outside;
  });
  return result;
}

} // namespace prosup::image
