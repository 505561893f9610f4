#include <algorithm>

#include "prosup/image/filters.h"

namespace prosup::image {

namespace {

/// Fills the values of a line beyond its known part [begin, end).
void extend_line(float* line, std::size_t stride, long begin, long end, long size) {
  const auto at = [&](long i) -> float& { return line[std::size_t(i) * stride]; };
  const long last = end - 1;
  for (long k = 1; k <= begin; ++k)
    at(begin - k) = end - begin == 1 ? at(begin) : 2.f * at(begin) - at(std::min(begin + k, last));
  for (long k = 1; last + k < size; ++k)
    at(last + k) = end - begin == 1 ? at(last) : 2.f * at(last) - at(std::max(last - k, begin));
}

} // namespace

ScalarImage extended(const ScalarImage& image, unsigned n_layers) {
  const auto& known = image.grid.size;
  VoxelGrid grid = image.grid;
  for (unsigned d = 0; d < 3; ++d)
    grid.size[d] += 2 * n_layers;
  grid.origin = image.grid.physical(-double(n_layers), -double(n_layers), -double(n_layers));
  ScalarImage result(grid);
  for (std::size_t k = 0; k < known[2]; ++k)
    for (std::size_t j = 0; j < known[1]; ++j)
      std::copy_n(&image(0, j, k), known[0], &result(n_layers, j + n_layers, k + n_layers));
  const std::size_t stride[3] = {1, grid.size[0], grid.size[0] * grid.size[1]};
  for (unsigned d = 0; d < 3; ++d)
    for (std::size_t v = 0; v < result.values.size(); ++v)
      if (v / stride[d] % grid.size[d] == 0) // the start of a line along d
        extend_line(&result.values[v], stride[d], n_layers, long(n_layers + known[d]),
                    long(grid.size[d]));
  return result;
}

} // namespace prosup::image
