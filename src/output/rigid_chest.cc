#include "rigid_chest.h"

#include <algorithm>
#include <cmath>

#include "prosup/image/filters.h"

namespace prosup::output {

using dealii::Point;
using dealii::Tensor;
using image::LabelImage;
using image::VectorImage;
using image::VoxelGrid;

namespace {

/// The part of its motion relative to the chest that a point keeps at a distance from the tissue
/// that moves by `motion` (both mm): 1 at the tissue, 0 in the distance. Its slope is at most 1.5
/// over the distance of its fall, so that the point does not overtake what is nearer.
double kept_part(double distance, double motion) {
  constexpr double least_fall = 10.; // mm
  const double t = std::clamp(distance / std::max(least_fall, 2. * motion), 0., 1.);
  return 1. - t * t * (3. - 2. * t);
}

/// To a thousandth of a mm, so that a file of what changes smoothly can be packed.
float rounded(double value) {
  constexpr double steps = 1024.; // per mm
  return static_cast<float>(std::round(steps * value) / steps);
}

} // namespace

void turn_into_chest(VectorImage& field, const LabelImage& in_mesh, const RigidChest& chest) {
  const VoxelGrid& grid = field.grid;
  const double diagonal = grid.spacing.norm(); // within which voxels interpolate in the mesh
  const image::ScalarImage distance = image::distance_from(in_mesh);
  for (std::size_t k = 0, v = 0; k < grid.size[2]; ++k)
    for (std::size_t j = 0; j < grid.size[1]; ++j)
      for (std::size_t i = 0; i < grid.size[0]; ++i, ++v) {
        if (in_mesh.values[v] != 0)
          continue;
        const Point<3> x = grid.physical(double(i), double(j), double(k));
        const Tensor<1, 3> rigid = chest.motion(x) - x;
        const auto& u = field.values[v];
        const Tensor<1, 3> relative = Tensor<1, 3>({u[0], u[1], u[2]}) - rigid;
        const bool is_chest = chest.contains && chest.contains(x);
        const double part =
            is_chest ? 0. : kept_part(double(distance.values[v]) - diagonal, relative.norm());
        for (unsigned d = 0; d < 3; ++d)
          field.values[v][d] = rounded(rigid[d] + part * relative[d]);
      }
}

std::function<bool(const Point<3>&)> voxels_with(const LabelImage& labels, unsigned label,
                                                 const image::RigidTransform& to_labels) {
  return [&labels, label, to_labels](const Point<3>& point) {
    const Point<3> index = labels.grid.continuous_index(to_labels(point));
    std::array<std::size_t, 3> nearest{};
    for (unsigned d = 0; d < 3; ++d) {
      const double rounded = std::round(index[d]);
      if (!(rounded >= 0. && rounded < double(labels.grid.size[d])))
        return false;
      nearest[d] = static_cast<std::size_t>(rounded);
    }
    return labels(nearest[0], nearest[1], nearest[2]) == label;
  };
}

} // namespace prosup::output
