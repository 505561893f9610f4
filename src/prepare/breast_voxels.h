#ifndef PROSUP_SRC_PREPARE_BREAST_VOXELS_H
#define PROSUP_SRC_PREPARE_BREAST_VOXELS_H

#include <array>
#include <cstdint>
#include <vector>

#include "prosup/image/voxel_image.h"

namespace prosup::prepare {

/// The voxels of a mask as a list, each with the numbers of its neighbours in the list.
struct BreastVoxels {
  explicit BreastVoxels(const image::LabelImage& mask);

  static constexpr std::uint32_t none = 0xffffffffu;

  image::VoxelGrid grid;
  std::vector<std::uint32_t> voxel;                     ///< linear index in the grid
  std::vector<std::array<std::uint32_t, 6>> neighbours; ///< or `none`
  std::array<float, 6> weight;                          ///< of each neighbour, sum 1

  std::array<std::size_t, 3> index(std::size_t i) const {
    const std::size_t v = voxel[i], n = grid.size[0], m = grid.size[1];
    return {v % n, v / n % m, v / (n * m)};
  }
};

/// A slowly varying field on coarse blocks of a grid, from weighted samples in its voxels.
class SmoothField {
public:
  /// `width` is the standard deviation of the smoothing, mm.
  SmoothField(const image::VoxelGrid& fine, double width);

  /// Weighted means over the neighbourhood; `values` and `weights` are those of `voxels`.
  void fit(const BreastVoxels& voxels, const std::vector<float>& values,
           const std::vector<float>& weights);
  /// The field at the voxels.
  void sample(const BreastVoxels& voxels, std::vector<float>& values) const;

private:
  double width_;
  std::array<std::size_t, 3> block_; ///< voxels in a block
  image::ScalarImage field_;
};

} // namespace prosup::prepare

#endif
