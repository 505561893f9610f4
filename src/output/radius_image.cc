#include "prosup/output/radius_image.h"

#include <cmath>

#include "prosup/mesh/scan_conversion.h"

namespace prosup::output {

using evaluation::Covariance;
using image::ScalarImage;

namespace {

/// The squared radius at the voxels of one mesh, 0 elsewhere.
ScalarImage squared_radius(const image::VoxelGrid& grid, const mesh::UnloadedMesh& mesh,
                           const std::vector<Covariance>& covariances) {
  ScalarImage image(grid);
  for (const auto& cell : mesh.mesh.cells)
    mesh::scan_convert_tet(
        grid,
        {mesh.unloaded[cell[0]], mesh.unloaded[cell[1]], mesh.unloaded[cell[2]],
         mesh.unloaded[cell[3]]},
        [&](std::size_t i, std::size_t j, std::size_t k, const std::array<double, 4>& weights) {
          Covariance covariance;
          for (unsigned a = 0; a < 4; ++a)
            covariance += weights[a] * covariances[cell[a]];
          const double radius = evaluation::error_bar(covariance).radius_95;
          image(i, j, k) = static_cast<float>(radius * radius);
        });
  return image;
}

} // namespace

ScalarImage radius_image(const image::VoxelGrid& grid,
                         const PerPosition<mesh::UnloadedMesh>& meshes,
                         const evaluation::Uncertainty::Covariances& covariances) {
  ScalarImage image = squared_radius(grid, meshes.prone, covariances.prone);
  const ScalarImage other = squared_radius(grid, meshes.supine, covariances.supine);
  for (std::size_t v = 0; v < image.values.size(); ++v) {
    const float a = image.values[v], b = other.values[v];
    image.values[v] = std::sqrt(a > 0.f && b > 0.f ? 0.5f * (a + b) : a + b);
  }
  return image;
}

} // namespace prosup::output
