#ifndef PROSUP_IMAGE_VOXEL_IMAGE_H
#define PROSUP_IMAGE_VOXEL_IMAGE_H

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace prosup::image {

using dealii::Point;
using dealii::Tensor;

/// A regular grid in physical space (LPS, mm), with the conventions of ITK: the centre of
/// voxel i is  origin + direction * diag(spacing) * i,  and the columns of `direction` are the
/// unit vectors of the grid axes. The first index runs fastest in memory.
struct VoxelGrid {
  std::array<std::size_t, 3> size{0, 0, 0}; ///< voxels along each axis of the grid
  Point<3> origin;                          ///< centre of the first voxel, mm
  Tensor<1, 3> spacing{{1., 1., 1.}};       ///< mm
  Tensor<2, 3> direction{{{1., 0., 0.}, {0., 1., 0.}, {0., 0., 1.}}}; ///< columns: the axes

  /// Number of voxels.
  std::size_t n_voxels() const { return size[0] * size[1] * size[2]; }

  /// Where a voxel is in memory.
  std::size_t linear_index(std::size_t i, std::size_t j, std::size_t k) const {
    return i + size[0] * (j + size[1] * k);
  }

  /// Physical position of a (continuous) index, mm.
  Point<3> physical(double i, double j, double k) const;

  /// Continuous index of a physical position: the inverse of physical().
  Point<3> continuous_index(const Point<3>& position) const;

  /// Whether the size is the same and all voxel centres agree to `tolerance` voxels.
  bool coincides_with(const VoxelGrid& other, double tolerance = 1e-3) const;

  /// mm^3.
  double voxel_volume() const { return spacing[0] * spacing[1] * spacing[2]; }
};

/// A grid of cubic voxels with axes along LPS that contains the box from `low` to `high` and
/// `margin` mm around it. Voxel centres are multiples of `spacing`, mm, so that small changes
/// of the box do not move them.
VoxelGrid grid_around(const Point<3>& low, const Point<3>& high, double spacing, double margin);

/// Values on a VoxelGrid.
template <typename T>
struct VoxelImage {
  VoxelGrid grid;
  std::vector<T> values;

  VoxelImage() = default;
  explicit VoxelImage(const VoxelGrid& g, T fill = T()) : grid(g), values(g.n_voxels(), fill) {}

  T& operator()(std::size_t i, std::size_t j, std::size_t k) {
    return values[grid.linear_index(i, j, k)];
  }
  const T& operator()(std::size_t i, std::size_t j, std::size_t k) const {
    return values[grid.linear_index(i, j, k)];
  }
};

using ScalarImage = VoxelImage<float>;
using LabelImage = VoxelImage<std::uint8_t>;
/// Displacements u(X), LPS mm: the voxel at X is taken to X + u(X).
using VectorImage = VoxelImage<std::array<float, 3>>;

} // namespace prosup::image

#endif
