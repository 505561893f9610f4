#ifndef PROSUP_MESH_SURFACE_TOPOLOGY_H
#define PROSUP_MESH_SURFACE_TOPOLOGY_H

#include <vector>

#include "triangle_mesh.h"

namespace prosup::mesh {

/// An edge a b of a closed surface, with its triangles (a, b, left) and (b, a, right).
struct SurfaceEdge {
  unsigned a, b;
  unsigned left, right;
  unsigned left_triangle, right_triangle;
};

/// A closed triangle surface whose edges can be split, collapsed and flipped. For the curves
/// where its patches meet, see creases.h.
class SurfaceTopology {
public:
  explicit SurfaceTopology(const TriangleMesh& surface);

  std::size_t n_vertices() const { return points_.size(); }
  bool is_used(unsigned vertex) const { return !star_[vertex].empty(); }
  const Point<3>& point(unsigned vertex) const { return points_[vertex]; }
  void move(unsigned vertex, const Point<3>& position) { points_[vertex] = position; }

  const std::array<unsigned, 3>& triangle(unsigned t) const { return triangles_[t]; }
  unsigned patch(unsigned t) const { return patch_[t]; }

  /// Triangles around a vertex.
  const std::vector<unsigned>& star(unsigned vertex) const { return star_[vertex]; }
  std::vector<unsigned> neighbours(unsigned vertex) const;

  /// All edges, a < b.
  std::vector<std::array<unsigned, 2>> edges() const;

  /// False if a b is no edge, or not one of exactly two triangles.
  bool find_edge(unsigned a, unsigned b, SurfaceEdge& edge) const;

  /// Adds a vertex at `position` on the edge.
  void split(const SurfaceEdge& edge, const Point<3>& position);

  /// Merges `removed` into `kept`, the ends of an edge. They must have no other common
  /// neighbours than `left` and `right`.
  void collapse(const SurfaceEdge& edge, unsigned removed, unsigned kept);

  /// Replaces the edge a b by left right.
  void flip(const SurfaceEdge& edge);

  /// The surface without what was removed.
  TriangleMesh compressed() const;

private:
  void replace_in_triangle(unsigned t, unsigned from, unsigned to);
  void remove_from_star(unsigned vertex, unsigned t);
  void remove_triangle(unsigned t);
  void add_triangle(const std::array<unsigned, 3>& triangle, std::uint8_t patch);

  std::vector<Point<3>> points_;
  std::vector<std::array<unsigned, 3>> triangles_;
  std::vector<std::uint8_t> patch_;
  std::vector<bool> removed_; // triangles
  std::vector<std::vector<unsigned>> star_;
};

} // namespace prosup::mesh

#endif
