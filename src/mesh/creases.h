#ifndef PROSUP_MESH_CREASES_H
#define PROSUP_MESH_CREASES_H

#include "surface_topology.h"

namespace prosup::mesh {

// Creases are the edges between two patches of a surface: a plane and the free surface, or
// two planes. Sets of patches are bit masks, bit p for patch p.

/// Set of the patches around a vertex.
unsigned patches(const SurfaceTopology& surface, unsigned vertex);

/// Set of the patches at an edge: two on a crease.
inline unsigned patches(const SurfaceTopology& surface, const SurfaceEdge& edge) {
  return 1u << surface.patch(edge.left_triangle) | 1u << surface.patch(edge.right_triangle);
}

inline bool is_crease(const SurfaceTopology& surface, const SurfaceEdge& edge) {
  return surface.patch(edge.left_triangle) != surface.patch(edge.right_triangle);
}

/// Vertices to which creases lead from `vertex`: none within a patch, two along a crease,
/// another number at a corner.
std::vector<unsigned> crease_neighbours(const SurfaceTopology& surface, unsigned vertex);

} // namespace prosup::mesh

#endif
