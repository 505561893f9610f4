#include "prosup/similarity/domain.h"

#include <algorithm>

#include "prosup/image/sampling.h"

namespace prosup::similarity {

using dealii::Point;
using image::LabelImage;
using image::VoxelGrid;

namespace {

/// For each axis of the grid and either end: does the body touch that face?
std::array<std::array<bool, 2>, 3> touched_faces(const LabelImage& labels) {
  std::array<std::array<bool, 2>, 3> touched{};
  const auto& size = labels.grid.size;
  std::size_t v = 0;
  for (std::size_t k = 0; k < size[2]; ++k)
    for (std::size_t j = 0; j < size[1]; ++j)
      for (std::size_t i = 0; i < size[0]; ++i, ++v) {
        if (labels.values[v] == 0)
          continue;
        const std::size_t index[3] = {i, j, k};
        for (unsigned d = 0; d < 3; ++d) {
          touched[d][0] = touched[d][0] || index[d] == 0;
          touched[d][1] = touched[d][1] || index[d] + 1 == size[d];
        }
      }
  return touched;
}

bool beyond(const VoxelGrid& grid, const std::array<std::array<bool, 2>, 3>& faces,
            const Point<3>& position) {
  const Point<3> index = grid.continuous_index(position);
  for (unsigned d = 0; d < 3; ++d)
    if ((faces[d][0] && index[d] < -0.5) ||
        (faces[d][1] && index[d] > static_cast<double>(grid.size[d]) - 0.5))
      return true;
  return false;
}

} // namespace

void Box::include(const Point<3>& point) {
  for (unsigned d = 0; d < 3; ++d) {
    low[d] = std::min(low[d], point[d]);
    high[d] = std::max(high[d], point[d]);
  }
}

void Box::include(const Box& other) {
  for (unsigned d = 0; d < 3; ++d) {
    low[d] = std::min(low[d], other.low[d]);
    high[d] = std::max(high[d], other.high[d]);
  }
}

void Box::grow(double distance) {
  for (unsigned d = 0; d < 3; ++d) {
    low[d] -= distance;
    high[d] += distance;
  }
}

VoxelGrid common_grid(const Box& box, double spacing, double margin, MPI_Comm communicator) {
  // Lower ends as negative numbers, so that one maximum serves both.
  double ends[6];
  for (unsigned d = 0; d < 3; ++d) {
    ends[d] = -box.low[d];
    ends[3 + d] = box.high[d];
  }
  MPI_Allreduce(MPI_IN_PLACE, ends, 6, MPI_DOUBLE, MPI_MAX, communicator);
  return image::grid_around(Point<3>(-ends[0], -ends[1], -ends[2]),
                            Point<3>(ends[3], ends[4], ends[5]), spacing, margin);
}

SimilarityDomain similarity_domain(const VoxelGrid& grid, const Scene& scene, unsigned n_layers) {
  SimilarityDomain domain{grid, std::vector<bool>(grid.n_voxels()), n_layers, scene.air, nullptr};
  if (!scene.excluded.prone.values.empty() || !scene.excluded.supine.values.empty())
    domain.excluded = &scene.excluded;
  for (const Position position : both_positions) {
    const LabelImage& labels = scene.labels[position];
    const auto faces = touched_faces(labels);
    std::size_t v = 0;
    for (std::size_t k = 0; k < grid.size[2]; ++k)
      for (std::size_t j = 0; j < grid.size[1]; ++j)
        for (std::size_t i = 0; i < grid.size[0]; ++i, ++v) {
          const Point<3> position =
              grid.physical(static_cast<double>(i), static_cast<double>(j), static_cast<double>(k));
          const unsigned label = image::nearest_label(labels, position);
          if (beyond(labels.grid, faces, position) || label == scene.chest_label ||
              (label == scene.unknown_label && label != 0))
            domain.no_air[v] = true;
        }
  }
  return domain;
}

} // namespace prosup::similarity
