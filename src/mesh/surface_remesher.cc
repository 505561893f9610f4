#include "surface_remesher.h"

#include <algorithm>
#include <cmath>

#include "creases.h"
#include "triangle_shape.h"

namespace prosup::mesh {

namespace {

using Vector = dealii::Tensor<1, 3>;
using Edge = SurfaceEdge;

constexpr unsigned nobody = ~0u;

double length(const SurfaceTopology& surface, unsigned a, unsigned b) {
  return (surface.point(a) - surface.point(b)).norm();
}

} // namespace

SurfaceRemesher::SurfaceRemesher(const TriangleMesh& surface, const LevelSet& phi,
                                 double edge_length)
    : topology_(surface), projection_(phi, 0.5 * edge_length), edge_length_(edge_length) {}

void SurfaceRemesher::run() {
  constexpr unsigned n_passes = 6, n_final_passes = 4;
  for (unsigned pass = 0; pass < n_passes; ++pass) {
    split_long_edges();
    collapse_short_edges();
    flip_edges();
    relax();
  }
  for (unsigned pass = 0; pass < n_final_passes; ++pass) {
    flip_edges();
    relax();
  }
}

void SurfaceRemesher::move_to_level(double level) {
  projection_.set_level(level);
  for (unsigned v = 0; v < topology_.n_vertices(); ++v)
    if (topology_.is_used(v)) {
      Point<3> target = topology_.point(v);
      if (projection_.apply(target, patches(topology_, v)) && may_move(v, target, nobody))
        topology_.move(v, target);
    }
}

void SurfaceRemesher::split_long_edges() {
  const double longest = 4. / 3. * edge_length_;
  Edge edge;
  for (const auto& [a, b] : topology_.edges())
    if (length(topology_, a, b) > longest && topology_.find_edge(a, b, edge)) {
      Point<3> middle(0.5 * (topology_.point(a) + topology_.point(b)));
      projection_.apply(middle, patches(topology_, edge));
      topology_.split(edge, middle);
    }
}

void SurfaceRemesher::collapse_short_edges() {
  const double shortest = 4. / 5. * edge_length_;
  std::vector<std::pair<double, std::array<unsigned, 2>>> short_edges;
  for (const auto& edge : topology_.edges())
    if (const double l = length(topology_, edge[0], edge[1]); l < shortest)
      short_edges.push_back({l, edge});
  std::sort(short_edges.begin(), short_edges.end());
  for (const auto& [l, edge] : short_edges)
    if (topology_.is_used(edge[0]) && topology_.is_used(edge[1]) &&
        length(topology_, edge[0], edge[1]) < shortest && !collapse(edge[0], edge[1]))
      collapse(edge[1], edge[0]);
}

bool SurfaceRemesher::collapse(unsigned removed, unsigned kept) {
  Edge edge;
  if (!topology_.find_edge(removed, kept, edge))
    return false;
  // A vertex may leave along its crease only, and a corner not at all.
  const unsigned around_removed = patches(topology_, removed);
  const std::size_t n_creases = crease_neighbours(topology_, removed).size();
  if (around_removed != patches(topology_, edge) ||
      n_creases != (is_crease(topology_, edge) ? 2 : 0))
    return false;
  const std::vector<unsigned> others = topology_.neighbours(kept);
  const std::vector<unsigned> moved = topology_.neighbours(removed);
  const auto n_common = std::count_if(moved.begin(), moved.end(), [&](unsigned v) {
    return std::find(others.begin(), others.end(), v) != others.end();
  });
  if (n_common != 2 || topology_.star(edge.left).size() <= 3 ||
      topology_.star(edge.right).size() <= 3)
    return false;
  Point<3> target = topology_.point(kept);
  if (around_removed == patches(topology_, kept) &&
      crease_neighbours(topology_, kept).size() == n_creases) {
    target = Point<3>(0.5 * (topology_.point(removed) + target));
    if (!projection_.apply(target, around_removed))
      return false;
  }
  const auto too_far = [&](unsigned v) {
    return (topology_.point(v) - target).norm() > 4. / 3. * edge_length_;
  };
  if (std::any_of(moved.begin(), moved.end(), too_far) ||
      std::any_of(others.begin(), others.end(), too_far) || !may_move(removed, target, kept) ||
      !may_move(kept, target, removed))
    return false;
  // A triangle with all corners on the rim of a plane would lie on its cap.
  for (const unsigned t : topology_.star(removed)) {
    auto triangle = topology_.triangle(t);
    std::replace(triangle.begin(), triangle.end(), removed, kept);
    if (t != edge.left_triangle && t != edge.right_triangle &&
        in_foreign_plane(topology_.patch(t), triangle))
      return false;
  }
  topology_.collapse(edge, removed, kept);
  topology_.move(kept, target);
  return true;
}

void SurfaceRemesher::flip_edges() {
  Edge edge;
  for (const auto& [a, b] : topology_.edges())
    if (topology_.find_edge(a, b, edge) && flip_helps(edge))
      topology_.flip(edge);
}

bool SurfaceRemesher::flip_helps(const Edge& edge) const {
  if (is_crease(topology_, edge))
    return false;
  const auto excess = [&](unsigned v, int change) {
    const int deviation = int(topology_.star(v).size()) + change - 6;
    return deviation * deviation;
  };
  const int before =
      excess(edge.a, 0) + excess(edge.b, 0) + excess(edge.left, 0) + excess(edge.right, 0);
  const int after =
      excess(edge.a, -1) + excess(edge.b, -1) + excess(edge.left, 1) + excess(edge.right, 1);
  Edge present;
  const auto opposite = topology_.neighbours(edge.left);
  if (after >= before || topology_.star(edge.a).size() <= 3 || topology_.star(edge.b).size() <= 3 ||
      std::find(opposite.begin(), opposite.end(), edge.right) != opposite.end() ||
      topology_.find_edge(edge.left, edge.right, present))
    return false;
  return length(topology_, edge.left, edge.right) < 1.5 * edge_length_ &&
         flipped_is_acceptable(edge, edge.a, edge.right, edge.left) &&
         flipped_is_acceptable(edge, edge.right, edge.b, edge.left);
}

bool SurfaceRemesher::flipped_is_acceptable(const Edge& edge, unsigned a, unsigned b,
                                            unsigned c) const {
  const unsigned patch = topology_.patch(edge.left_triangle);
  if (in_foreign_plane(patch, {a, b, c}))
    return false;
  const Corners3 after = corners({a, b, c});
  const auto replaces = [&](unsigned t) {
    return may_become(corners(topology_.triangle(t)), after, patch, projection_);
  };
  return replaces(edge.left_triangle) && replaces(edge.right_triangle);
}

bool SurfaceRemesher::in_foreign_plane(unsigned patch,
                                       const std::array<unsigned, 3>& triangle) const {
  const unsigned common = patches(topology_, triangle[0]) & patches(topology_, triangle[1]) &
                          patches(topology_, triangle[2]);
  return (common & ~SurfaceProjection::set_of(patch) &
          ~SurfaceProjection::set_of(TriangleMesh::free_surface)) != 0;
}

Corners3 SurfaceRemesher::corners(const std::array<unsigned, 3>& triangle) const {
  return {topology_.point(triangle[0]), topology_.point(triangle[1]), topology_.point(triangle[2])};
}

void SurfaceRemesher::relax() {
  for (unsigned v = 0; v < topology_.n_vertices(); ++v)
    if (topology_.is_used(v)) {
      Point<3> target = relaxed_position(v);
      if (projection_.apply(target, patches(topology_, v)) && may_move(v, target, nobody))
        topology_.move(v, target);
    }
}

Point<3> SurfaceRemesher::relaxed_position(unsigned vertex) const {
  const Point<3>& x = topology_.point(vertex);
  const std::vector<unsigned> along = crease_neighbours(topology_, vertex);
  if (along.size() == 2)
    return Point<3>(0.5 * x + 0.25 * (topology_.point(along[0]) + topology_.point(along[1])));
  if (!along.empty())
    return x;
  Vector centroid;
  double area_sum = 0.;
  for (const unsigned t : topology_.star(vertex)) {
    const Corners3 x = corners(topology_.triangle(t));
    const double area = area_vector(x).norm();
    centroid += area / 3. * (x[0] + x[1] + x[2]);
    area_sum += area;
  }
  return area_sum > 0. ? Point<3>(centroid / area_sum) : x;
}

bool SurfaceRemesher::may_move(unsigned vertex, const Point<3>& target, unsigned except) const {
  for (const unsigned t : topology_.star(vertex)) {
    const auto& triangle = topology_.triangle(t);
    if (std::find(triangle.begin(), triangle.end(), except) != triangle.end())
      continue;
    const Corners3 before = corners(triangle);
    Corners3 after = before;
    for (unsigned i = 0; i < 3; ++i)
      if (triangle[i] == vertex)
        after[i] = target;
    if (!may_become(before, after, topology_.patch(t), projection_))
      return false;
  }
  return true;
}

} // namespace prosup::mesh
