#ifndef PROSUP_MESH_SURFACE_TOPOLOGY_H
#define PROSUP_MESH_SURFACE_TOPOLOGY_H

#include <vector>

#include "triangle_mesh.h"

namespace prosup::mesh {

/// A closed triangle surface whose edges can be split, collapsed and flipped.
/// Sets of patches are bit masks, bit p for patch p.
class SurfaceTopology {
public:
  /// The edge a b, triangles (a, b, left) and (b, a, right).
  struct Edge {
    unsigned a, b;
    unsigned left, right;
    unsigned left_triangle, right_triangle;
  };

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
  bool find_edge(unsigned a, unsigned b, Edge& edge) const;

  double length(unsigned a, unsigned b) const { return (points_[a] - points_[b]).norm(); }

  /// Patches around a vertex.
  unsigned patches(unsigned vertex) const;

  /// Patches at an edge: two on a crease.
  unsigned patches(const Edge& edge) const {
    return 1u << patch_[edge.left_triangle] | 1u << patch_[edge.right_triangle];
  }

  bool is_crease(const Edge& edge) const {
    return patch_[edge.left_triangle] != patch_[edge.right_triangle];
  }

  /// Vertices to which creases lead from `vertex`: none inside a patch, two
  /// along a crease, another number at corners.
  std::vector<unsigned> crease_neighbours(unsigned vertex) const;

  /// Adds a vertex at `position` on the edge.
  void split(const Edge& edge, const Point<3>& position);

  /// Merges `removed` into `kept`, the ends of an edge. The caller makes sure
  /// that they have no other common neighbours than `left` and `right`.
  void collapse(const Edge& edge, unsigned removed, unsigned kept);

  /// Replaces the edge a b by left right.
  void flip(const Edge& edge);

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
