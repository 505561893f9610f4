#include "prosup/output/displacement_fields.h"

#include <vector>

#include "prosup/core/error.h"
#include "prosup/image/filters.h"
#include "prosup/mesh/scan_conversion.h"
#include "rigid_chest.h"

namespace prosup::output {

namespace {

using dealii::Point;
using dealii::Tensor;
using evaluation::PointMapper;
using image::LabelImage;
using image::VectorImage;
using image::VoxelGrid;

/// Layers of voxels around the mesh that move with the closest point of its
/// surface. Interpolation at the surface needs one; the others let the field
/// turn smoothly around edges.
constexpr unsigned n_layers = 3;

struct Index {
  std::size_t i, j, k;
};

std::array<float, 3> as_value(const Tensor<1, 3>& u) {
  return {static_cast<float>(u[0]), static_cast<float>(u[1]), static_cast<float>(u[2])};
}

/// Calls `visit` for the neighbours of a voxel in the grid that share a face with it.
template <class Visit>
void for_each_neighbour(const Index& v, const std::array<std::size_t, 3>& size, Visit&& visit) {
  if (v.i > 0)
    visit(Index{v.i - 1, v.j, v.k});
  if (v.i + 1 < size[0])
    visit(Index{v.i + 1, v.j, v.k});
  if (v.j > 0)
    visit(Index{v.i, v.j - 1, v.k});
  if (v.j + 1 < size[1])
    visit(Index{v.i, v.j + 1, v.k});
  if (v.k > 0)
    visit(Index{v.i, v.j, v.k - 1});
  if (v.k + 1 < size[2])
    visit(Index{v.i, v.j, v.k + 1});
}

/// The voxels that are not known and share a face with one that is.
std::vector<Index> border_of(const LabelImage& known) {
  std::vector<Index> border;
  const auto& size = known.grid.size;
  for (std::size_t k = 0; k < size[2]; ++k)
    for (std::size_t j = 0; j < size[1]; ++j)
      for (std::size_t i = 0; i < size[0]; ++i) {
        if (known(i, j, k) != 0)
          continue;
        bool beside_known = false;
        for_each_neighbour({i, j, k}, size, [&](const Index& n) {
          beside_known = beside_known || known(n.i, n.j, n.k) != 0;
        });
        if (beside_known)
          border.push_back({i, j, k});
      }
  return border;
}

/// Defines the field in n_layers around what is known by `displacement(position)`,
/// and beyond by the nearest voxel.
template <class Displacement>
void complete(VectorImage& field, LabelImage known, Displacement&& displacement) {
  std::vector<Index> layer = border_of(known), next;
  if (layer.empty() && (known.values.empty() || known.values[0] == 0))
    throw Error("The breast mesh lies outside the grid of a displacement field; check that the "
                "images and the mesh belong together.");
  for (const Index& v : layer)
    known(v.i, v.j, v.k) = 1;
  for (unsigned l = 0; l < n_layers; ++l, layer.swap(next)) {
    next.clear();
    for (const Index& v : layer) {
      const Point<3> position = field.grid.physical(
          static_cast<double>(v.i), static_cast<double>(v.j), static_cast<double>(v.k));
      field(v.i, v.j, v.k) = as_value(displacement(position));
      if (l + 1 == n_layers)
        continue;
      for_each_neighbour(v, known.grid.size, [&](const Index& n) {
        if (known(n.i, n.j, n.k) == 0)
          next.push_back(n);
        known(n.i, n.j, n.k) = 1;
      });
    }
  }
  image::extend_from_nearest(field, known);
}

/// Calls `visit(i, j, k, cell, weights)` for the voxels in the mesh with nodes at
/// `nodes`.
template <class Visit>
void for_each_voxel(const VoxelGrid& grid, const std::vector<Point<3>>& nodes,
                    const mesh::TetMesh& mesh, Visit&& visit) {
  for (const auto& cell : mesh.cells)
    mesh::scan_convert_tet(
        grid, {nodes[cell[0]], nodes[cell[1]], nodes[cell[2]], nodes[cell[3]]},
        [&](std::size_t i, std::size_t j, std::size_t k, const std::array<double, 4>& weights) {
          visit(i, j, k, cell, weights);
        });
}

/// A mesh in two configurations.
struct MovedMesh {
  const mesh::TetMesh& mesh;
  const std::vector<Point<3>>&from, &to; ///< positions of the nodes
};

/// The field that takes the nodes of a mesh along, and points outside by `displacement(position)`.
template <class Displacement>
StateField between_nodes(const VoxelGrid& grid, const MovedMesh& moved, Displacement&& displacement,
                         const RigidChest& chest) {
  StateField result{VectorImage(grid), LabelImage(grid)};
  for_each_voxel(grid, moved.from, moved.mesh,
                 [&](auto i, auto j, auto k, const auto& cell, const auto& weights) {
                   Tensor<1, 3> u;
                   for (unsigned a = 0; a < 4; ++a)
                     u += weights[a] * (moved.to[cell[a]] - moved.from[cell[a]]);
                   result.displacement(i, j, k) = as_value(u);
                   result.valid(i, j, k) = 1;
                 });
  complete(result.displacement, result.valid, displacement);
  turn_into_chest(result.displacement, result.valid, chest);
  return result;
}

} // namespace

StateField unloaded_to_loaded(const VoxelGrid& grid, const mesh::UnloadedMesh& mesh,
                              const PointMapper& mapper, const RigidChest& chest) {
  return between_nodes(
      grid, {mesh.mesh, mesh.unloaded, mesh.mesh.points},
      [&](const Point<3>& X) { return mapper.to_loaded(X) - X; }, chest);
}

StateField loaded_to_unloaded(const VoxelGrid& grid, const mesh::UnloadedMesh& mesh,
                              const PointMapper& mapper, const RigidChest& chest) {
  return between_nodes(
      grid, {mesh.mesh, mesh.mesh.points, mesh.unloaded},
      [&](const Point<3>& x) { return mapper.to_unloaded(x) - x; }, chest);
}

StateField loaded_to_loaded(const VoxelGrid& grid, const mesh::UnloadedMesh& from,
                            const PointMapper& from_mapper, const PointMapper& to_mapper,
                            const RigidChest& chest) {
  VectorImage field(grid);
  LabelImage in_mesh(grid), valid(grid);
  for_each_voxel(grid, from.mesh.points, from.mesh,
                 [&](auto i, auto j, auto k, const auto& cell, const auto& weights) {
                   if (in_mesh(i, j, k) != 0) // on a face, mapped from the other side already
                     return;
                   Point<3> x, X;
                   for (unsigned a = 0; a < 4; ++a) {
                     x += weights[a] * Tensor<1, 3>(from.mesh.points[cell[a]]);
                     X += weights[a] * Tensor<1, 3>(from.unloaded[cell[a]]);
                   }
                   const auto mapped = to_mapper.map(X, evaluation::Configuration::unloaded);
                   field(i, j, k) = as_value(mapped.position - x);
                   in_mesh(i, j, k) = 1;
                   valid(i, j, k) = mapped.distance_outside <= evaluation::far_outside;
                 });
  complete(field, in_mesh,
           [&](const Point<3>& x) { return to_mapper.to_loaded(from_mapper.to_unloaded(x)) - x; });
  turn_into_chest(field, in_mesh, chest);
  return {std::move(field), std::move(valid)};
}

} // namespace prosup::output
