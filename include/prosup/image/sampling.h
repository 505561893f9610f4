#ifndef PROSUP_IMAGE_SAMPLING_H
#define PROSUP_IMAGE_SAMPLING_H

#include <algorithm>
#include <cmath>

#include "prosup/image/voxel_image.h"

namespace prosup::image {

/// Fast trilinear interpolation of an image, in arithmetic of type Real. Keeps a pointer to
/// the image, which must outlive it and have at least one voxel. Outside the centres of the
/// border voxels the value is that of the nearest point between them.
template <typename Real>
class BasicSampler {
public:
  explicit BasicSampler(const ScalarImage& image) : values_(image.values.data()) {
    const VoxelGrid& grid = image.grid;
    for (unsigned d = 0; d < 3; ++d) {
      offset_[d] = 0.;
      for (unsigned e = 0; e < 3; ++e) {
        to_index_[3 * d + e] = grid.direction[e][d] / grid.spacing[d];
        offset_[d] -= to_index_[3 * d + e] * grid.origin[e];
      }
      last_[d] = double(grid.size[d]) - 1.;
      last_cell_[d] = std::max(long(grid.size[d]) - 2, 0l);
    }
    // Along an axis of one voxel both ends of a cell are that voxel.
    stride_[0] = grid.size[0] > 1 ? 1 : 0;
    row_ = long(grid.size[0]);
    stride_[1] = grid.size[1] > 1 ? row_ : 0;
    slice_ = row_ * long(grid.size[1]);
    stride_[2] = grid.size[2] > 1 ? slice_ : 0;
  }

  /// Value at a physical position (LPS, mm).
  Real value(const Point<3>& position) const {
    const Cell cell = locate(position);
    Real face[4];
    along_first_axis(cell, face);
    const Real low = face[0] + cell.t[1] * (face[1] - face[0]);
    const Real high = face[2] + cell.t[1] * (face[3] - face[2]);
    return low + cell.t[2] * (high - low);
  }

  /// Returns the value and computes the exact gradient of the interpolant, value per mm.
  /// Where the position is clamped along an axis of the grid, the derivative along that axis
  /// is zero.
  Real value_and_gradient(const Point<3>& position, Tensor<1, 3>& gradient_per_mm) const {
    const Cell cell = locate(position);
    const float* v = cell.corner;
    const long s1 = stride_[1], s2 = stride_[2];
    Real face[4];
    along_first_axis(cell, face);
    Real slope[4];
    for (unsigned f = 0; f < 4; ++f) {
      const float* at = v + (f & 1u ? s1 : 0) + (f & 2u ? s2 : 0);
      slope[f] = at[stride_[0]] - at[0];
    }
    const Real low = face[0] + cell.t[1] * (face[1] - face[0]);
    const Real high = face[2] + cell.t[1] * (face[3] - face[2]);
    const Real slope_low = slope[0] + cell.t[1] * (slope[1] - slope[0]);
    const Real slope_high = slope[2] + cell.t[1] * (slope[3] - slope[2]);
    const Real rise_low = face[1] - face[0], rise_high = face[3] - face[2];
    const double per_voxel[3] = {cell.free[0] * (slope_low + cell.t[2] * (slope_high - slope_low)),
                                 cell.free[1] * (rise_low + cell.t[2] * (rise_high - rise_low)),
                                 cell.free[2] * (high - low)};
    for (unsigned d = 0; d < 3; ++d)
      gradient_per_mm[d] = to_index_[d] * per_voxel[0] + to_index_[3 + d] * per_voxel[1] +
                           to_index_[6 + d] * per_voxel[2];
    return low + cell.t[2] * (high - low);
  }

  /// Whether a position lies in the field of view, which ends at the outer faces of the
  /// border voxels.
  bool inside(const Point<3>& position) const {
    bool all = true;
    for (unsigned d = 0; d < 3; ++d) {
      const double x = index(position, d);
      all = all && x >= -0.5 && x <= last_[d] + 0.5;
    }
    return all;
  }

private:
  struct Cell {
    const float* corner; // the voxel of lowest index
    Real t[3];           // position in the cell, 0 to 1
    Real free[3];        // 0 where clamped, else 1
  };

  double index(const Point<3>& p, unsigned d) const {
    return to_index_[3 * d] * p[0] + to_index_[3 * d + 1] * p[1] + to_index_[3 * d + 2] * p[2] +
           offset_[d];
  }

  Cell locate(const Point<3>& position) const {
    Cell cell;
    long start[3];
    for (unsigned d = 0; d < 3; ++d) {
      const double x = index(position, d);
      // In this order of arguments a position that is not a number becomes 0
      // instead of an address outside the image.
      const double clamped = std::min(std::max(0., x), last_[d]);
      start[d] = std::min(long(clamped), last_cell_[d]);
      cell.t[d] = Real(clamped - double(start[d]));
      cell.free[d] = x == clamped ? Real(1) : Real(0);
    }
    cell.corner = values_ + start[0] + row_ * start[1] + slice_ * start[2];
    return cell;
  }

  void along_first_axis(const Cell& cell, Real (&face)[4]) const {
    for (unsigned f = 0; f < 4; ++f) {
      const float* at = cell.corner + (f & 1u ? stride_[1] : 0) + (f & 2u ? stride_[2] : 0);
      face[f] = at[0] + cell.t[0] * (at[stride_[0]] - at[0]);
    }
  }

  const float* values_;
  double to_index_[9]; // row d: derivative of index d by the position
  double offset_[3];
  double last_[3];
  long last_cell_[3];
  long stride_[3]; // to the next voxel of a cell
  long row_, slice_;
};

using Sampler = BasicSampler<float>;

/// Label of the voxel that contains a physical position (LPS, mm); 0 outside the field of
/// view.
inline std::uint8_t nearest_label(const LabelImage& labels, const Point<3>& position) {
  const VoxelGrid& grid = labels.grid;
  const Point<3> index = grid.continuous_index(position);
  std::size_t voxel[3];
  for (unsigned d = 0; d < 3; ++d) {
    const double nearest = std::floor(index[d] + 0.5);
    if (!(nearest >= 0. && nearest < double(grid.size[d])))
      return 0;
    voxel[d] = static_cast<std::size_t>(nearest);
  }
  return labels(voxel[0], voxel[1], voxel[2]);
}

} // namespace prosup::image

#endif
