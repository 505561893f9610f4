#ifndef PROSUP_MESH_SCAN_CONVERSION_H
#define PROSUP_MESH_SCAN_CONVERSION_H

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "prosup/image/voxel_image.h"

namespace prosup::mesh {

namespace internal {

/// The barycentric weights of a tetrahedron as affine functions of the voxel
/// index q:  w_a(q) = [a = 0] + gradient_a . (q - corner_0).
class IndexTetrahedron {
public:
  using Vector = dealii::Tensor<1, 3>;

  IndexTetrahedron(const image::VoxelGrid& grid, const std::array<dealii::Point<3>, 4>& corners) {
    const dealii::Tensor<2, 3> to_index = invert(grid.direction);
    for (unsigned a = 0; a < 4; ++a) {
      corners_[a] = to_index * (corners[a] - grid.origin);
      for (unsigned d = 0; d < 3; ++d)
        corners_[a][d] /= grid.spacing[d];
    }
    const Vector e1 = corners_[1] - corners_[0], e2 = corners_[2] - corners_[0],
                 e3 = corners_[3] - corners_[0];
    gradients_[1] = cross_product_3d(e2, e3);
    gradients_[2] = cross_product_3d(e3, e1);
    gradients_[3] = cross_product_3d(e1, e2);
    const double determinant = e1 * gradients_[1];
    const double longest =
        std::sqrt(std::max({e1.norm_square(), e2.norm_square(), e3.norm_square()}));
    // The sign of the physical volume: a left-handed grid mirrors the corners.
    const double volume = determinant * dealii::determinant(to_index);
    valid_ = std::isfinite(volume) && volume > 1e-12 * longest * longest * longest;
    if (!valid_)
      return;
    for (unsigned a = 1; a < 4; ++a)
      gradients_[a] /= determinant;
    gradients_[0] = -(gradients_[1] + gradients_[2] + gradients_[3]);
    for (unsigned a = 0; a < 4; ++a)
      tolerance_[a] = 1e-9 * (1. + gradients_[a].norm());
  }

  /// False if the tetrahedron is flat, inverted or not finite.
  bool valid() const { return valid_; }

  /// Range of indices along axis d that may lie inside.
  std::array<std::ptrdiff_t, 2> bounds(unsigned d, std::size_t size) const {
    const auto [low, high] =
        std::minmax({corners_[0][d], corners_[1][d], corners_[2][d], corners_[3][d]});
    return clipped(low - 1e-9, high + 1e-9, size);
  }

  /// The weights at index (0, j, k).
  std::array<double, 4> row_start(std::ptrdiff_t j, std::ptrdiff_t k) const {
    const Vector q({-corners_[0][0], static_cast<double>(j) - corners_[0][1],
                    static_cast<double>(k) - corners_[0][2]});
    std::array<double, 4> weights;
    for (unsigned a = 0; a < 4; ++a)
      weights[a] = gradients_[a] * q + (a == 0 ? 1. : 0.);
    return weights;
  }

  double step_along_row(unsigned a) const { return gradients_[a][0]; }

  /// The indices i of the row for which all weights are >= -tolerance.
  std::array<std::ptrdiff_t, 2> row_interval(const std::array<double, 4>& start,
                                             const std::array<std::ptrdiff_t, 2>& range) const {
    double low = static_cast<double>(range[0]), high = static_cast<double>(range[1]);
    for (unsigned a = 0; a < 4; ++a) {
      const double step = gradients_[a][0], margin = start[a] + tolerance_[a];
      if (step > smallest_step)
        low = std::max(low, -margin / step);
      else if (step < -smallest_step)
        high = std::min(high, -margin / step);
      else if (margin < 0.)
        return {0, -1};
    }
    if (!(low <= high))
      return {0, -1};
    return {static_cast<std::ptrdiff_t>(std::ceil(low)),
            static_cast<std::ptrdiff_t>(std::floor(high))};
  }

private:
  // Over a row of 10^4 voxels a smaller step changes a weight by less than the tolerance.
  static constexpr double smallest_step = 1e-14;

  static std::array<std::ptrdiff_t, 2> clipped(double low, double high, std::size_t size) {
    const double last = static_cast<double>(size) - 1.;
    return {static_cast<std::ptrdiff_t>(std::ceil(std::clamp(low, 0., last + 1.))),
            static_cast<std::ptrdiff_t>(std::floor(std::clamp(high, -1., last)))};
  }

  std::array<Vector, 4> corners_;
  std::array<Vector, 4> gradients_;
  std::array<double, 4> tolerance_{};
  bool valid_ = false;
};

} // namespace internal

/// Calls `visit(i, j, k, weights)` for each voxel of `grid` whose centre lies in the
/// tetrahedron with the physical `corners` (LPS mm). `weights` are the barycentric weights of
/// the centre (std::array<double, 4>, sum 1).
///
/// A centre on a face between two tetrahedra is visited for both of them: weights may be as
/// low as -1e-9, or minus the change of the weight over 1e-9 voxels, so that no centre is
/// missed between neighbours. Flat, inverted and non-finite tetrahedra are skipped. The grid
/// may be oblique or left-handed.
template <class Visit>
void scan_convert_tet(const image::VoxelGrid& grid, const std::array<dealii::Point<3>, 4>& corners,
                      Visit&& visit) {
  const internal::IndexTetrahedron tet(grid, corners);
  if (!tet.valid())
    return;
  const auto range_i = tet.bounds(0, grid.size[0]), range_j = tet.bounds(1, grid.size[1]),
             range_k = tet.bounds(2, grid.size[2]);
  for (std::ptrdiff_t k = range_k[0]; k <= range_k[1]; ++k)
    for (std::ptrdiff_t j = range_j[0]; j <= range_j[1]; ++j) {
      const std::array<double, 4> start = tet.row_start(j, k);
      const auto [first, last] = tet.row_interval(start, range_i);
      for (std::ptrdiff_t i = first; i <= last; ++i) {
        std::array<double, 4> weights;
        for (unsigned a = 0; a < 4; ++a)
          weights[a] = start[a] + static_cast<double>(i) * tet.step_along_row(a);
        visit(static_cast<std::size_t>(i), static_cast<std::size_t>(j), static_cast<std::size_t>(k),
              weights);
      }
    }
}

} // namespace prosup::mesh

#endif
