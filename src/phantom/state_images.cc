#include "prosup/phantom/state_images.h"

#include <algorithm>
#include <cmath>

#include "prosup/image/filters.h"
#include "prosup/mesh/scan_conversion.h"

namespace prosup::phantom {

using image::LabelImage;
using image::ScalarImage;
using image::VoxelGrid;

namespace {

constexpr double point_spread = 0.5;                      // standard deviation, voxels
constexpr double bias_spacing = 90., jitter_spacing = 8.; // mm, of the lattices
// A chest on which tissue slides may stand off it by the give of the contact.
constexpr double largest_gap = 0.5; // mm

template <class Visit>
void for_each_voxel(const VoxelGrid& grid, Visit&& visit) {
  std::size_t voxel = 0;
  for (std::size_t k = 0; k < grid.size[2]; ++k)
    for (std::size_t j = 0; j < grid.size[1]; ++j)
      for (std::size_t i = 0; i < grid.size[0]; ++i)
        visit(voxel++, grid.physical(double(i), double(j), double(k)));
}

void add_noise(ScalarImage& image, Modality modality, double sigma, Random random) {
  if (sigma > 0.)
    for (float& value : image.values)
      value = static_cast<float>(modality == Modality::mr ? rician(value, sigma, random)
                                                          : value + sigma * random.normal());
}

void multiply_by_bias(ScalarImage& image, double deviation, const SmoothNoise& field) {
  if (deviation > 0.)
    for_each_voxel(image.grid, [&](std::size_t voxel, const Point<3>& x) {
      image.values[voxel] *= static_cast<float>(std::exp(deviation * field(x)));
    });
}

/// Index of the voxel of the grid that is nearest to a position.
std::size_t nearest_voxel(const VoxelGrid& grid, const Point<3>& x) {
  const Point<3> index = grid.continuous_index(x);
  std::size_t nearest[3];
  for (unsigned d = 0; d < 3; ++d)
    nearest[d] =
        static_cast<std::size_t>(std::lround(std::clamp(index[d], 0., double(grid.size[d]) - 1.)));
  return grid.linear_index(nearest[0], nearest[1], nearest[2]);
}

} // namespace

MaterialPoints material_points(const VoxelGrid& grid, const mesh::UnloadedMesh& mesh) {
  MaterialPoints points{image::VectorImage(grid), LabelImage(grid)};
  for (const auto& cell : mesh.mesh.cells) {
    std::array<Point<3>, 4> corners;
    for (unsigned a = 0; a < 4; ++a)
      corners[a] = mesh.mesh.points[cell[a]];
    mesh::scan_convert_tet(grid, corners,
                           [&](std::size_t i, std::size_t j, std::size_t k, const auto& weights) {
                             dealii::Tensor<1, 3> u;
                             for (unsigned a = 0; a < 4; ++a)
                               u += weights[a] * (mesh.unloaded[cell[a]] - corners[a]);
                             for (unsigned d = 0; d < 3; ++d)
                               points.to_unloaded(i, j, k)[d] = static_cast<float>(u[d]);
                             points.in_tissue(i, j, k) = 1;
                           });
  }
  return points;
}

StateImages::StateImages(const Anatomy& anatomy, const MaterialPoints& points, std::uint64_t seed,
                         unsigned state)
    : anatomy_(anatomy), points_(points), seed_(seed), state_(state) {}

Point<3> StateImages::unloaded(std::size_t voxel, const Point<3>& x) const {
  const auto& u = points_.to_unloaded.values[voxel];
  return {x[0] + u[0], x[1] + u[1], x[2] + u[2]};
}

Label StateImages::label_at(std::size_t voxel, const Point<3>& x) const {
  if (points_.in_tissue.values[voxel])
    return anatomy_.gland_level(unloaded(voxel, x)) > 0. ? gland : fat;
  return anatomy_.geometry().distance_to_chest(x) < largest_gap ? chest : air;
}

LabelImage StateImages::labels() const {
  LabelImage labels(points_.in_tissue.grid);
  for_each_voxel(labels.grid, [&](std::size_t voxel, const Point<3>& x) {
    labels.values[voxel] = label_at(voxel, x);
  });
  return labels;
}

LabelImage StateImages::jittered_labels(double jitter) const {
  const LabelImage exact = labels();
  if (!(jitter > 0.))
    return exact;
  std::vector<SmoothNoise> components;
  for (unsigned d = 0; d < 3; ++d)
    components.emplace_back(jitter_spacing, seed_, Stream::jitter, 3 * state_ + d);
  LabelImage displaced(exact.grid);
  for_each_voxel(exact.grid, [&](std::size_t voxel, const Point<3>& x) {
    Point<3> from = x;
    for (unsigned d = 0; d < 3; ++d)
      from[d] += jitter * components[d](x);
    displaced.values[voxel] = exact.values[nearest_voxel(exact.grid, from)];
  });
  return displaced;
}

ScalarImage StateImages::image(const Texture& texture, Modality modality,
                               const ImageErrors& errors) const {
  ScalarImage image(points_.in_tissue.grid);
  for_each_voxel(image.grid, [&](std::size_t voxel, const Point<3>& x) {
    const Label label = label_at(voxel, x);
    image.values[voxel] =
        static_cast<float>(label == air     ? texture.air(modality)
                           : label == chest ? texture.chest(modality, x)
                                            : texture.tissue(modality, unloaded(voxel, x)));
  });
  image = image::gaussian_smooth(image, point_spread * image.grid.spacing[0]);
  if (modality == Modality::mr)
    multiply_by_bias(image, errors.bias_field,
                     SmoothNoise(bias_spacing, seed_, Stream::bias, state_));
  add_noise(image, modality, errors.noise, Random(seed_, Stream::noise, state_));
  return image;
}

} // namespace prosup::phantom
