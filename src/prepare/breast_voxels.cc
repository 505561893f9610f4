#include "breast_voxels.h"

#include <algorithm>
#include <cmath>

#include "prosup/image/filters.h"
#include "prosup/image/sampling.h"

namespace prosup::prepare {

BreastVoxels::BreastVoxels(const image::LabelImage& mask) : grid(mask.grid) {
  std::vector<std::uint32_t> number(mask.values.size(), none);
  for (std::size_t v = 0; v < mask.values.size(); ++v)
    if (mask.values[v] != 0) {
      number[v] = std::uint32_t(voxel.size());
      voxel.push_back(std::uint32_t(v));
    }
  neighbours.resize(voxel.size());
  const std::size_t stride[3] = {1, grid.size[0], grid.size[0] * grid.size[1]};
  for (std::size_t i = 0; i < voxel.size(); ++i) {
    const auto at = index(i);
    for (unsigned d = 0; d < 3; ++d) {
      neighbours[i][2 * d] = at[d] > 0 ? number[voxel[i] - stride[d]] : none;
      neighbours[i][2 * d + 1] = at[d] + 1 < grid.size[d] ? number[voxel[i] + stride[d]] : none;
    }
  }
  double sum = 0.;
  for (unsigned d = 0; d < 3; ++d)
    sum += 2. / grid.spacing[d];
  for (unsigned n = 0; n < 6; ++n)
    weight[n] = float(1. / grid.spacing[n / 2] / sum);
}

namespace {

constexpr double block_edge = 5.; // mm

} // namespace

SmoothField::SmoothField(const image::VoxelGrid& fine, double width) : width_(width) {
  image::VoxelGrid coarse = fine;
  image::Point<3> first;
  for (unsigned d = 0; d < 3; ++d) {
    block_[d] = std::size_t(std::max(1l, std::lround(block_edge / fine.spacing[d])));
    coarse.size[d] = (fine.size[d] + block_[d] - 1) / block_[d];
    coarse.spacing[d] = fine.spacing[d] * double(block_[d]);
    first[d] = 0.5 * (double(block_[d]) - 1.);
  }
  coarse.origin = fine.physical(first[0], first[1], first[2]);
  field_ = image::ScalarImage(coarse);
}

void SmoothField::fit(const BreastVoxels& voxels, const std::vector<float>& values,
                      const std::vector<float>& weights) {
  image::ScalarImage sum(field_.grid), weight(field_.grid);
  for (std::size_t i = 0; i < voxels.voxel.size(); ++i) {
    const auto at = voxels.index(i);
    const std::size_t block =
        field_.grid.linear_index(at[0] / block_[0], at[1] / block_[1], at[2] / block_[2]);
    sum.values[block] += weights[i] * values[i];
    weight.values[block] += weights[i];
  }
  sum = image::gaussian_smooth(sum, width_);
  weight = image::gaussian_smooth(weight, width_);
  const float largest = *std::max_element(weight.values.begin(), weight.values.end());
  for (std::size_t v = 0; v < field_.values.size(); ++v)
    field_.values[v] = sum.values[v] / std::max(weight.values[v], 1e-6f * largest);
}

void SmoothField::sample(const BreastVoxels& voxels, std::vector<float>& values) const {
  const image::Sampler sampler(field_);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto at = voxels.index(i);
    values[i] = sampler.value(voxels.grid.physical(double(at[0]), double(at[1]), double(at[2])));
  }
}

} // namespace prosup::prepare
