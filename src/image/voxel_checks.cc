#include "voxel_checks.h"

#include <algorithm>
#include <cmath>

#include "prosup/core/error.h"
#include "prosup/core/log.h"

namespace prosup::image {

Point<3> voxel_position(const VoxelGrid& grid, std::size_t linear_index) {
  const std::size_t row = linear_index / grid.size[0];
  return grid.physical(double(linear_index % grid.size[0]), double(row % grid.size[1]),
                       double(row / grid.size[1]));
}

namespace {

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

} // namespace prosup::image
