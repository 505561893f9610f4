#include "voxels.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "prosup/evaluation/point_mapper.h"
#include "prosup/mesh/scan_conversion.h"

namespace prosup::benchmarks {

using dealii::Point;
using dealii::Tensor;
using evaluation::PointMapper;

namespace {

/// Cubic voxels around the points, one face of which is in y = border.
image::VoxelGrid grid_of(const std::vector<Point<3>>& points, double spacing, double border,
                         double shift) {
  constexpr double margin = 3.; // voxels
  Point<3> low = points.front(), high = low;
  for (const Point<3>& p : points)
    for (unsigned d = 0; d < 3; ++d) {
      low[d] = std::min(low[d], p[d]);
      high[d] = std::max(high[d], p[d]);
    }
  image::VoxelGrid grid;
  grid.spacing = Tensor<1, 3>({spacing, spacing, spacing});
  for (unsigned d = 0; d < 3; ++d) {
    const double offset = d == 1 ? border / spacing : shift;
    const double first = std::floor(low[d] / spacing - offset - margin) + offset;
    const double last = d == 1 ? offset : std::ceil(high[d] / spacing - offset + margin) + offset;
    grid.origin[d] = (first + 0.5) * spacing;
    grid.size[d] = static_cast<std::size_t>(std::lround(last - first));
  }
  return grid;
}

/// Distance of a point from the surface of the cube [0, edge]^3 without y = edge.
double distance_from_cube(const Point<3>& p, double edge) {
  const double inwards[5] = {p[0], edge - p[0], p[1], p[2], edge - p[2]};
  double outside = 0., nearest = edge;
  for (const double d : inwards) {
    outside += d < 0. ? d * d : 0.;
    nearest = std::min(nearest, d);
  }
  return outside > 0. ? std::sqrt(outside) : nearest;
}

} // namespace

image::LabelImage rasterise(const mesh::TetMesh& mesh, double spacing, double border,
                            double shift) {
  image::LabelImage mask(grid_of(mesh.points, spacing, border, shift));
  for (const auto& c : mesh.cells)
    mesh::scan_convert_tet(
        mask.grid, {mesh.points[c[0]], mesh.points[c[1]], mesh.points[c[2]], mesh.points[c[3]]},
        [&](std::size_t i, std::size_t j, std::size_t k, const std::array<double, 4>&) {
          mask(i, j, k) = 2;
        });
  return mask;
}

Distances statistics(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const auto at = static_cast<std::size_t>(0.95 * static_cast<double>(values.size() - 1));
  return {values.back(), values[at],
          std::accumulate(values.begin(), values.end(), 0.) / static_cast<double>(values.size())};
}

std::vector<double> displacement_errors(const image::LabelImage& mask,
                                        const mesh::UnloadedMesh& recovered,
                                        const mesh::UnloadedMesh& truth) {
  const PointMapper ours(recovered), theirs(truth);
  std::vector<double> errors;
  for (std::size_t k = 0; k < mask.grid.size[2]; ++k)
    for (std::size_t j = 0; j < mask.grid.size[1]; ++j)
      for (std::size_t i = 0; i < mask.grid.size[0]; ++i)
        if (mask(i, j, k) != 0) {
          const Point<3> x = mask.grid.physical(double(i), double(j), double(k));
          errors.push_back(ours.to_unloaded(x).distance(theirs.to_unloaded(x)));
        }
  return errors;
}

std::vector<double> surface_distances(const mesh::UnloadedMesh& recovered, double edge) {
  std::set<unsigned> nodes;
  for (const mesh::BoundaryFace& face : recovered.mesh.boundary_faces)
    if (face.part == mesh::BoundaryPart::skin)
      nodes.insert(face.nodes.begin(), face.nodes.end());
  std::vector<double> distances;
  for (const unsigned node : nodes)
    distances.push_back(distance_from_cube(recovered.unloaded[node], edge));
  return distances;
}

} // namespace prosup::benchmarks
