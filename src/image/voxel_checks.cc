#include "voxel_checks.h"

#include <algorithm>
#include <cmath>

#include "prosup/core/error.h"
#include "prosup/core/log.h"
#include "stored_values.h"

namespace prosup::image {

Point<3> voxel_position(const VoxelGrid& grid, std::size_t linear_index) {
  const std::size_t row = linear_index / grid.size[0];
  return grid.physical(double(linear_index % grid.size[0]), double(row % grid.size[1]),
                       double(row / grid.size[1]));
}

namespace {

constexpr std::size_t most_voxels = 2000000000; // what an MPI count can hold

bool is_bad(float value) {
  return !std::isfinite(value);
}
bool is_bad(const std::array<float, 3>& value) {
  return is_bad(value[0]) || is_bad(value[1]) || is_bad(value[2]);
}

template <typename T>
void check(const VoxelImage<T>& image, const std::filesystem::path& file) {
  const auto n_bad = std::count_if(image.values.begin(), image.values.end(),
                                   [](const T& value) { return is_bad(value); });
  if (n_bad == 0)
    return;
  const auto first = std::find_if(image.values.begin(), image.values.end(),
                                  [](const T& value) { return is_bad(value); });
  const Point<3> x =
      voxel_position(image.grid, static_cast<std::size_t>(first - image.values.begin()));
  throw Error(format("The image '%s' has %zu voxels that are not finite numbers, the first at LPS "
                     "(%.1f, %.1f, %.1f) mm; replace them by finite values.",
                     file.string().c_str(), static_cast<std::size_t>(n_bad), x[0], x[1], x[2]));
}

} // namespace

void check_finite(const ScalarImage& image, const std::filesystem::path& file) {
  check(image, file);
}

void check_finite(const VectorImage& image, const std::filesystem::path& file) {
  check(image, file);
}

LabelImage rounded_labels(const ScalarImage& values, double step, const std::filesystem::path& file,
                          Remarks& remarks) {
  // Values that were stored as integers with a scale are off by half a step at most, and by
  // rounding. More than that are the values in between that resampling leaves.
  const double tolerance = std::min(std::max(1e-3, 0.51 * step), 0.02);
  LabelImage labels(values.grid);
  double largest = 0.;
  for (std::size_t v = 0; v < values.values.size(); ++v) {
    const double value = values.values[v], label = std::round(value);
    const double off = std::abs(value - label);
    if (!(off <= tolerance) || label < 0. || label > 255.) {
      const Point<3> x = voxel_position(values.grid, v);
      throw Error(format("'%s' is no label image: it holds %g at LPS (%.1f, %.1f, %.1f) mm, but "
                         "labels are integers from 0 to 255; give the mask, not the image.",
                         file.string().c_str(), value, x[0], x[1], x[2]));
    }
    largest = std::max(largest, off);
    labels.values[v] = static_cast<std::uint8_t>(label);
  }
  if (largest > 0.)
    remarks.add(format("The labels of '%s' are no integers, but differ from them by no more than "
                       "%.1e; they were rounded.",
                       file.string().c_str(), largest));
  return labels;
}

void check_size(const std::array<std::size_t, 3>& size, const std::filesystem::path& file) {
  if (saturated_product({size[0], size[1], size[2]}) > most_voxels)
    throw Error(format("'%s' has %zu x %zu x %zu voxels by its header, more than the %zu that can "
                       "be held; correct the header, or resample the image.",
                       file.string().c_str(), size[0], size[1], size[2], most_voxels));
}

} // namespace prosup::image
