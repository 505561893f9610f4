#include "window_sum.h"

#include <algorithm>
#include <cmath>

namespace prosup::similarity {

WindowSum::WindowSum(const image::VoxelGrid& grid, double radius)
    : size_(grid.size), other_(grid.n_voxels()) {
  for (unsigned d = 0; d < 3; ++d)
    radius_[d] = static_cast<std::size_t>(std::max(1l, std::lround(radius / grid.spacing[d])));
}

void WindowSum::apply(Field& field) {
  const std::size_t row = size_[0], plane = row * size_[1];
  along_rows(field.data(), other_.data());
  for (std::size_t k = 0; k < size_[2]; ++k)
    along_lines(other_.data() + k * plane, field.data() + k * plane, 1, row);
  along_lines(field.data(), other_.data(), 2, plane);
  field.swap(other_);
}

void WindowSum::along_rows(const float* in, float* out) const {
  const std::size_t n = size_[0], r = radius_[0];
  for (std::size_t row = 0; row < size_[1] * size_[2]; ++row, in += n, out += n) {
    double sum = 0.;
    for (std::size_t i = 0; i < std::min(r, n); ++i)
      sum += in[i];
    for (std::size_t i = 0; i < n; ++i) {
      if (i + r < n)
        sum += in[i + r];
      if (i > r)
        sum -= in[i - r - 1];
      out[i] = static_cast<float>(sum);
    }
  }
}

void WindowSum::along_lines(const float* in, float* out, std::size_t axis, std::size_t width) {
  const std::size_t n = size_[axis], r = radius_[axis];
  running_.assign(width, 0.);
  const auto add = [&](const float* line, double sign) {
    for (std::size_t i = 0; i < width; ++i)
      running_[i] += sign * line[i];
  };
  for (std::size_t j = 0; j < std::min(r, n); ++j)
    add(in + j * width, 1.);
  for (std::size_t j = 0; j < n; ++j) {
    if (j + r < n)
      add(in + (j + r) * width, 1.);
    if (j > r)
      add(in + (j - r - 1) * width, -1.);
    for (std::size_t i = 0; i < width; ++i)
      out[j * width + i] = static_cast<float>(running_[i]);
  }
}

} // namespace prosup::similarity
