#include "creases.h"

namespace prosup::mesh {

unsigned patches(const SurfaceTopology& surface, unsigned vertex) {
  unsigned result = 0;
  for (const unsigned t : surface.star(vertex))
    result |= 1u << surface.patch(t);
  return result;
}

std::vector<unsigned> crease_neighbours(const SurfaceTopology& surface, unsigned vertex) {
  std::vector<unsigned> result;
  const unsigned around = patches(surface, vertex);
  if ((around & (around - 1)) == 0) // a single patch
    return result;
  SurfaceEdge edge;
  for (const unsigned other : surface.neighbours(vertex))
    if (!surface.find_edge(vertex, other, edge) || is_crease(surface, edge))
      result.push_back(other);
  return result;
}

} // namespace prosup::mesh
