#include "flood.h"

#include <cstdint>

namespace prosup::prepare {

namespace {

struct Reached {
  std::uint32_t i, j, k;
  float path; // mm
};

} // namespace

void flood(image::LabelImage& reached, const image::LabelImage& passable, double depth_mm) {
  const image::VoxelGrid& grid = reached.grid;
  std::vector<Reached> front, next;
  const auto visit = [&](std::size_t i, std::size_t j, std::size_t k, double path) {
    const std::size_t voxel = grid.linear_index(i, j, k);
    if (path > depth_mm || reached.values[voxel] != 0 || passable.values[voxel] == 0)
      return;
    reached.values[voxel] = 1;
    next.push_back({std::uint32_t(i), std::uint32_t(j), std::uint32_t(k), float(path)});
  };
  const auto visit_neighbours = [&](const Reached& at) {
    const std::size_t index[3] = {at.i, at.j, at.k};
    for (unsigned d = 0; d < 3; ++d)
      for (const int step : {-1, 1}) {
        std::size_t to[3] = {index[0], index[1], index[2]};
        to[d] += std::size_t(step); // wraps around below 0, which is outside
        if (to[d] < grid.size[d])
          visit(to[0], to[1], to[2], double(at.path) + grid.spacing[d]);
      }
  };
  std::size_t voxel = 0;
  for (std::size_t k = 0; k < grid.size[2]; ++k)
    for (std::size_t j = 0; j < grid.size[1]; ++j)
      for (std::size_t i = 0; i < grid.size[0]; ++i, ++voxel)
        if (reached.values[voxel] == 1)
          front.push_back({std::uint32_t(i), std::uint32_t(j), std::uint32_t(k), 0.f});
  while (!front.empty()) {
    next.clear();
    for (const Reached& at : front)
      visit_neighbours(at);
    front.swap(next);
  }
}

bool front_is_first(const image::VoxelGrid& grid) {
  return grid.direction[1][1] > 0.;
}

image::LabelImage seen_from_front(const image::LabelImage& passable) {
  image::LabelImage seen(passable.grid);
  const auto& size = seen.grid.size;
  const bool forward = front_is_first(seen.grid);
  for (std::size_t k = 0; k < size[2]; ++k)
    for (std::size_t i = 0; i < size[0]; ++i)
      for (std::size_t n = 0; n < size[1]; ++n) {
        const std::size_t j = forward ? n : size[1] - 1 - n;
        if (passable(i, j, k) == 0)
          break;
        seen(i, j, k) = 1;
      }
  return seen;
}

} // namespace prosup::prepare
