#include "surface_topology.h"

#include <algorithm>

namespace prosup::mesh {

SurfaceTopology::SurfaceTopology(const TriangleMesh& surface)
    : points_(surface.points), star_(surface.points.size()) {
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    add_triangle(surface.triangles[t], surface.patch[t]);
}

std::vector<unsigned> SurfaceTopology::neighbours(unsigned vertex) const {
  std::vector<unsigned> result;
  for (const unsigned t : star_[vertex])
    for (const unsigned other : triangles_[t])
      if (other != vertex && std::find(result.begin(), result.end(), other) == result.end())
        result.push_back(other);
  return result;
}

std::vector<std::array<unsigned, 2>> SurfaceTopology::edges() const {
  std::vector<std::array<unsigned, 2>> result;
  for (std::size_t t = 0; t < triangles_.size(); ++t)
    for (unsigned i = 0; i < 3 && !removed_[t]; ++i) {
      const unsigned a = triangles_[t][i], b = triangles_[t][(i + 1) % 3];
      if (a < b)
        result.push_back({a, b});
    }
  return result;
}

bool SurfaceTopology::find_edge(unsigned a, unsigned b, SurfaceEdge& edge) const {
  unsigned n_left = 0, n_right = 0;
  edge.a = a;
  edge.b = b;
  for (const unsigned t : star_[a])
    for (unsigned i = 0; i < 3; ++i) {
      const auto& corners = triangles_[t];
      if (corners[i] == a && corners[(i + 1) % 3] == b) {
        edge.left = corners[(i + 2) % 3];
        edge.left_triangle = t;
        ++n_left;
      } else if (corners[i] == b && corners[(i + 1) % 3] == a) {
        edge.right = corners[(i + 2) % 3];
        edge.right_triangle = t;
        ++n_right;
      }
    }
  return n_left == 1 && n_right == 1;
}

void SurfaceTopology::split(const SurfaceEdge& edge, const Point<3>& position) {
  const auto middle = unsigned(points_.size());
  points_.push_back(position);
  star_.emplace_back();
  // (a, b, left) keeps the half at a, (b, a, right) too.
  remove_from_star(edge.b, edge.left_triangle);
  remove_from_star(edge.b, edge.right_triangle);
  replace_in_triangle(edge.left_triangle, edge.b, middle);
  replace_in_triangle(edge.right_triangle, edge.b, middle);
  star_[middle] = {edge.left_triangle, edge.right_triangle};
  add_triangle({middle, edge.b, edge.left}, patch_[edge.left_triangle]);
  add_triangle({edge.b, middle, edge.right}, patch_[edge.right_triangle]);
}

void SurfaceTopology::collapse(const SurfaceEdge& edge, unsigned removed, unsigned kept) {
  remove_triangle(edge.left_triangle);
  remove_triangle(edge.right_triangle);
  for (const unsigned t : star_[removed]) {
    replace_in_triangle(t, removed, kept);
    star_[kept].push_back(t);
  }
  star_[removed].clear();
}

void SurfaceTopology::flip(const SurfaceEdge& edge) {
  remove_from_star(edge.b, edge.left_triangle);
  remove_from_star(edge.a, edge.right_triangle);
  replace_in_triangle(edge.left_triangle, edge.b, edge.right);
  replace_in_triangle(edge.right_triangle, edge.a, edge.left);
  star_[edge.right].push_back(edge.left_triangle);
  star_[edge.left].push_back(edge.right_triangle);
}

TriangleMesh SurfaceTopology::compressed() const {
  TriangleMesh result;
  std::vector<unsigned> number(points_.size());
  for (std::size_t v = 0; v < points_.size(); ++v)
    if (!star_[v].empty()) {
      number[v] = unsigned(result.points.size());
      result.points.push_back(points_[v]);
    }
  for (std::size_t t = 0; t < triangles_.size(); ++t)
    if (!removed_[t]) {
      const auto& corners = triangles_[t];
      result.triangles.push_back({number[corners[0]], number[corners[1]], number[corners[2]]});
      result.patch.push_back(patch_[t]);
    }
  return result;
}

void SurfaceTopology::replace_in_triangle(unsigned t, unsigned from, unsigned to) {
  std::replace(triangles_[t].begin(), triangles_[t].end(), from, to);
}

void SurfaceTopology::remove_from_star(unsigned vertex, unsigned t) {
  auto& star = star_[vertex];
  star.erase(std::find(star.begin(), star.end(), t));
}

void SurfaceTopology::remove_triangle(unsigned t) {
  for (const unsigned vertex : triangles_[t])
    remove_from_star(vertex, t);
  removed_[t] = true;
}

void SurfaceTopology::add_triangle(const std::array<unsigned, 3>& triangle, std::uint8_t patch) {
  const auto t = unsigned(triangles_.size());
  triangles_.push_back(triangle);
  patch_.push_back(patch);
  removed_.push_back(false);
  for (const unsigned vertex : triangle)
    star_[vertex].push_back(t);
}

} // namespace prosup::mesh
