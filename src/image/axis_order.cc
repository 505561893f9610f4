#include "axis_order.h"

#include <deal.II/base/tensor.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace prosup::image {

namespace {

using Order = std::array<unsigned, 3>;

/// The axis of the grid that lies closest to each axis of LPS.
Order closest_axes(const Tensor<2, 3>& direction) {
  Order best{0, 1, 2}, order = best;
  double largest = -1.;
  do {
    double sum = 0.;
    for (unsigned d = 0; d < 3; ++d)
      sum += std::abs(direction[d][order[d]]);
    if (sum > largest + 1e-9) { // at 45 degrees, rounding decides nothing
      largest = sum;
      best = order;
    }
  } while (std::next_permutation(order.begin(), order.end()));
  return best;
}

template <typename T>
VoxelImage<T> reordered(VoxelImage<T> image) {
  const VoxelGrid& from = image.grid;
  const Order order = closest_axes(from.direction);
  VoxelGrid to;
  std::array<bool, 3> turned{};
  const auto axis = [&](unsigned d) {
    Tensor<1, 3> direction;
    for (unsigned e = 0; e < 3; ++e)
      direction[e] = (turned[d] ? -1. : 1.) * from.direction[e][order[d]];
    return direction;
  };
  turned[2] = axis(2)[2] < 0.;
  turned[0] = dealii::cross_product_3d(axis(0), axis(1)) * axis(2) < 0.;
  if (order == Order{0, 1, 2} && !turned[0] && !turned[2])
    return image;
  std::array<std::size_t, 3> first{}; // voxel of the old grid
  std::array<std::ptrdiff_t, 3> stride{};
  const std::array<std::size_t, 3> old_stride{1, from.size[0], from.size[0] * from.size[1]};
  for (unsigned d = 0; d < 3; ++d) {
    to.size[d] = from.size[order[d]];
    to.spacing[d] = from.spacing[order[d]];
    for (unsigned e = 0; e < 3; ++e)
      to.direction[e][d] = axis(d)[e];
    first[order[d]] = turned[d] ? to.size[d] - 1 : 0;
    stride[d] = (turned[d] ? -1 : 1) * static_cast<std::ptrdiff_t>(old_stride[order[d]]);
  }
  to.origin = from.physical(double(first[0]), double(first[1]), double(first[2]));
  VoxelImage<T> result(to);
  const T* begin = image.values.data() + from.linear_index(first[0], first[1], first[2]);
  T* next = result.values.data();
  for (std::size_t k = 0; k < to.size[2]; ++k)
    for (std::size_t j = 0; j < to.size[1]; ++j)
      for (std::size_t i = 0; i < to.size[0]; ++i)
        *next++ = begin[static_cast<std::ptrdiff_t>(i) * stride[0] +
                        static_cast<std::ptrdiff_t>(j) * stride[1] +
                        static_cast<std::ptrdiff_t>(k) * stride[2]];
  return result;
}

} // namespace

ScalarImage in_usual_order(ScalarImage image) {
  return reordered(std::move(image));
}

LabelImage in_usual_order(LabelImage labels) {
  return reordered(std::move(labels));
}

} // namespace prosup::image
