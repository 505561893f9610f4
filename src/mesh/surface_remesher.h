#ifndef PROSUP_MESH_SURFACE_REMESHER_H
#define PROSUP_MESH_SURFACE_REMESHER_H

#include "surface_projection.h"
#include "surface_topology.h"
#include "triangle_mesh.h"

namespace prosup::mesh {

/// Makes the triangles of a contour nearly equilateral, by splits, collapses and
/// flips of edges and relaxation of vertices along the surface (Botsch and
/// Kobbelt, A remeshing approach to multiresolution modeling, 2004). Vertices
/// stay on phi = level, on the faces of the box, or on the curves in which these
/// meet.
class SurfaceRemesher {
public:
  SurfaceRemesher(const TriangleMesh& surface, const LevelSet& phi, double edge_length);

  /// Remeshes until the edges have about the wanted length.
  void run();

  /// Moves the free surface to phi = level without changing the connections.
  void move_to_level(double level);

  /// The projection to the level last moved to.
  const SurfaceProjection& projection() const { return projection_; }

  TriangleMesh result() const { return topology_.compressed(); }

private:
  void split_long_edges();
  void collapse_short_edges();
  void flip_edges();
  void relax();

  bool collapse(unsigned removed, unsigned kept);
  bool flip_helps(const SurfaceEdge& edge) const;
  /// Whether the triangle a b c, half of a flip of `edge`, is as good as both it replaces.
  bool flipped_is_acceptable(const SurfaceEdge& edge, unsigned a, unsigned b, unsigned c) const;

  /// Whether all corners of a triangle of `patch` lie in the plane of another patch.
  bool in_foreign_plane(unsigned patch, const std::array<unsigned, 3>& triangle) const;

  std::array<Point<3>, 3> corners(const std::array<unsigned, 3>& triangle) const;

  Point<3> relaxed_position(unsigned vertex) const;

  /// Whether the triangles around `vertex`, but those that hold `except`, keep
  /// their orientation and some area when it moves to `target`.
  bool may_move(unsigned vertex, const Point<3>& target, unsigned except) const;

  SurfaceTopology topology_;
  SurfaceProjection projection_;
  double edge_length_;
};

} // namespace prosup::mesh

#endif
