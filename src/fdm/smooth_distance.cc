#include "smooth_distance.h"

#include <algorithm>
#include <cmath>

#include "prosup/image/filters.h"
#include "prosup/image/sampling.h"

namespace prosup::fdm {

SmoothDistance::SmoothDistance(const image::LabelImage& labels, unsigned label, const Point<3>& low,
                               const Point<3>& high, double spacing) {
  // Without this the stairs would be sampled at random.
  const image::ScalarImage fine = image::gaussian_smooth(
      image::signed_distance(image::select_labels(labels, {label})), 0.25 * spacing);
  const image::BasicSampler<float> sampler(fine);
  // Values serve as coefficients: what is linear stays as it is.
  coefficients_ = image::ScalarImage(image::grid_around(low, high, 0.5 * spacing, spacing));
  const image::VoxelGrid& grid = coefficients_.grid;
  std::size_t n = 0;
  for (std::size_t k = 0; k < grid.size[2]; ++k)
    for (std::size_t j = 0; j < grid.size[1]; ++j)
      for (std::size_t i = 0; i < grid.size[0]; ++i)
        coefficients_.values[n++] = sampler.value(grid.physical(double(i), double(j), double(k)));
}

double SmoothDistance::value(const Point<3>& position, Tensor<1, 3>& normal) const {
  const image::VoxelGrid& grid = coefficients_.grid;
  std::size_t first[3];
  double weight[3][3], slope[3][3];
  for (unsigned d = 0; d < 3; ++d) {
    const double index = (position[d] - grid.origin[d]) / grid.spacing[d];
    // In this order of arguments what is not a number becomes 1.
    const double clamped = std::min(std::max(1., index), double(grid.size[d]) - 2.);
    const double nearest = std::floor(clamped + 0.5), t = clamped - nearest;
    first[d] = std::size_t(nearest) - 1;
    weight[d][0] = 0.5 * (0.5 - t) * (0.5 - t);
    weight[d][1] = 0.75 - t * t;
    weight[d][2] = 0.5 * (0.5 + t) * (0.5 + t);
    slope[d][0] = t - 0.5;
    slope[d][1] = -2. * t;
    slope[d][2] = t + 0.5;
  }
  double value = 0.;
  normal = 0.;
  for (unsigned k = 0; k < 3; ++k)
    for (unsigned j = 0; j < 3; ++j)
      for (unsigned i = 0; i < 3; ++i) {
        const double coefficient = coefficients_(first[0] + i, first[1] + j, first[2] + k);
        const double wx = weight[0][i], wy = weight[1][j], wz = weight[2][k];
        value += wx * wy * wz * coefficient;
        normal[0] += slope[0][i] * wy * wz * coefficient;
        normal[1] += wx * slope[1][j] * wz * coefficient;
        normal[2] += wx * wy * slope[2][k] * coefficient;
      }
  const double length = normal.norm();
  if (length > 0.)
    normal /= length;
  return value;
}

} // namespace prosup::fdm
