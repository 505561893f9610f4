#include "prosup/pipeline/unloaded_grid.h"

#include <algorithm>

namespace prosup::pipeline {

using dealii::Point;

image::VoxelGrid unloaded_grid(const std::vector<const mesh::UnloadedMesh*>& meshes, double spacing,
                               double margin) {
  Point<3> low = meshes.front()->unloaded.front(), high = low;
  for (const mesh::UnloadedMesh* mesh : meshes)
    for (const Point<3>& position : mesh->unloaded)
      for (unsigned d = 0; d < 3; ++d) {
        low[d] = std::min(low[d], position[d]);
        high[d] = std::max(high[d], position[d]);
      }
  return image::grid_around(low, high, spacing, margin);
}

} // namespace prosup::pipeline
