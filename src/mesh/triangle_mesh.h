#ifndef PROSUP_MESH_TRIANGLE_MESH_H
#define PROSUP_MESH_TRIANGLE_MESH_H

#include <array>
#include <vector>

#include "prosup/mesh/tet_mesh.h"

namespace prosup::mesh {

/// A closed surface in the frame of the grid (mm along the grid axes, voxel 0 at
/// the origin), normals outwards. `patch` tells what each triangle lies on:
/// `free_surface`, or 2 d + s for the lower (s = 0) or upper (s = 1) face of the
/// image along axis d.
struct TriangleMesh {
  static constexpr std::uint8_t free_surface = 6;

  std::vector<Point<3>> points;
  std::vector<std::array<unsigned, 3>> triangles;
  std::vector<std::uint8_t> patch;
};

/// Volume enclosed by a closed surface, mm^3; negative if the normals point inwards.
inline double enclosed_volume(const TriangleMesh& surface) {
  double volume = 0.;
  for (const auto& t : surface.triangles)
    volume +=
        tet_volume(Point<3>(), surface.points[t[0]], surface.points[t[1]], surface.points[t[2]]);
  return volume;
}

/// The set of patches around each node, bit p for patch p.
inline std::vector<unsigned> node_patches(const TriangleMesh& surface) {
  std::vector<unsigned> patches(surface.points.size(), 0u);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    for (const unsigned node : surface.triangles[t])
      patches[node] |= 1u << surface.patch[t];
  return patches;
}

/// Area of the free surface, mm^2.
inline double free_area(const TriangleMesh& surface) {
  double area = 0.;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const auto& [a, b, c] = surface.triangles[t];
    const auto& x = surface.points;
    if (surface.patch[t] == TriangleMesh::free_surface)
      area += 0.5 * cross_product_3d(x[b] - x[a], x[c] - x[a]).norm();
  }
  return area;
}

} // namespace prosup::mesh

#endif
