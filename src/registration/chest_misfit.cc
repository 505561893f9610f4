#include <algorithm>
#include <cmath>

#include "outlines.h"
#include "prosup/core/quantile.h"
#include "prosup/image/sampling.h"
#include "prosup/registration/agreement.h"

namespace prosup::registration {

using dealii::Point;
using image::LabelImage;
using image::ScalarImage;
using image::VoxelGrid;

namespace {

constexpr double edge = 2.; // mm, of the voxels: a distance is known to a fraction of it

/// The corners of a field of view.
void include(similarity::Box& box, const VoxelGrid& grid) {
  for (unsigned corner = 0; corner < 8; ++corner) {
    std::array<double, 3> at;
    for (unsigned d = 0; d < 3; ++d)
      at[d] = ((corner >> d) & 1u) != 0 ? static_cast<double>(grid.size[d]) - 0.5 : -0.5;
    box.include(grid.physical(at[0], at[1], at[2]));
  }
}

bool shows(const VoxelGrid& grid, const Point<3>& position) {
  const Point<3> index = grid.continuous_index(position);
  for (unsigned d = 0; d < 3; ++d)
    if (!(index[d] > -0.5 && index[d] < static_cast<double>(grid.size[d]) - 0.5))
      return false;
  return true;
}

/// A label image on the voxels that both are compared on.
struct Chest {
  LabelImage labels, mask;
  std::vector<bool> seen;
  ScalarImage distance;

  Chest(const VoxelGrid& grid, const LabelImage& original, unsigned chest_label,
        unsigned unknown_label)
      : labels(grid), mask(grid), seen(grid.n_voxels()) {
    std::size_t v = 0;
    for (std::size_t k = 0; k < grid.size[2]; ++k)
      for (std::size_t j = 0; j < grid.size[1]; ++j)
        for (std::size_t i = 0; i < grid.size[0]; ++i, ++v) {
          const Point<3> at =
              grid.physical(static_cast<double>(i), static_cast<double>(j), static_cast<double>(k));
          seen[v] = shows(original.grid, at);
          labels.values[v] = image::nearest_label(original, at);
          mask.values[v] = labels.values[v] == chest_label;
          if (labels.values[v] == unknown_label)
            labels.values[v] = 0; // no tissue
        }
    distance = distance_to(mask);
  }

  /// Distances of the middles of the faces between chest and tissue to the other chest.
  void add_distances(const Chest& other, std::size_t& n_faces,
                     std::vector<double>& distances) const {
    for_each_neighbours(labels.grid, [&](std::size_t v, std::size_t w) {
      if (mask.values[v] == mask.values[w] || labels.values[v] == 0 || labels.values[w] == 0)
        return;
      ++n_faces;
      if (other.seen[v] && other.seen[w])
        distances.push_back(0.5 * std::abs(other.distance.values[v] + other.distance.values[w]));
    });
  }
};

} // namespace

ChestMisfit measure_chest_misfit(const similarity::Scene& scene) {
  similarity::Box box;
  for (const Position position : both_positions)
    include(box, scene.labels[position].grid);
  const VoxelGrid grid = image::grid_around(box.low, box.high, edge, 0.);
  const Chest prone(grid, scene.labels.prone, scene.chest_label, scene.unknown_label),
      supine(grid, scene.labels.supine, scene.chest_label, scene.unknown_label);
  if (prone.distance.values.empty() || supine.distance.values.empty())
    return {};
  std::size_t n_faces = 0;
  std::vector<double> distances;
  prone.add_distances(supine, n_faces, distances);
  supine.add_distances(prone, n_faces, distances);
  ChestMisfit misfit;
  if (n_faces > 0)
    misfit.shared = static_cast<double>(distances.size()) / static_cast<double>(n_faces);
  misfit.median = quantile(distances, 0.5);
  misfit.p95 = quantile(distances, 0.95);
  return misfit;
}

} // namespace prosup::registration
