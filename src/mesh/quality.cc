#include "prosup/mesh/quality.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "prosup/core/error.h"

namespace prosup::mesh {

namespace {

using Vector = dealii::Tensor<1, 3>;
using Corners = std::array<Point<3>, 4>;

std::array<double, 6> edge_lengths(const Corners& p) {
  return {(p[1] - p[0]).norm(), (p[2] - p[0]).norm(), (p[3] - p[0]).norm(),
          (p[2] - p[1]).norm(), (p[3] - p[1]).norm(), (p[3] - p[2]).norm()};
}

/// Areas of the faces opposite to each corner, mm^2.
std::array<double, 4> face_areas(const Corners& p) {
  const auto area = [&](unsigned a, unsigned b, unsigned c) {
    return 0.5 * cross_product_3d(p[b] - p[a], p[c] - p[a]).norm();
  };
  return {area(1, 2, 3), area(0, 2, 3), area(0, 1, 3), area(0, 1, 2)};
}

} // namespace

std::array<Point<3>, 4> cell_corners(const TetMesh& mesh, std::size_t c) {
  const auto& nodes = mesh.cells[c];
  return {mesh.points[nodes[0]], mesh.points[nodes[1]], mesh.points[nodes[2]],
          mesh.points[nodes[3]]};
}

double radius_ratio(const Corners& p) {
  const double volume = tet_volume(p[0], p[1], p[2], p[3]);
  const auto areas = face_areas(p);
  const double surface = areas[0] + areas[1] + areas[2] + areas[3];
  // Crelle: 6 V R is the area of a triangle whose sides are the products of opposite edges.
  const auto e = edge_lengths(p);
  const double a = e[0] * e[5], b = e[1] * e[4], c = e[2] * e[3], s = 0.5 * (a + b + c);
  const double crelle = std::sqrt(std::max(0., s * (s - a) * (s - b) * (s - c)));
  if (crelle <= 0. || surface <= 0.)
    return 0.;
  return 3. * (3. * volume / surface) * (6. * std::abs(volume) / crelle);
}

double min_height(const Corners& p) {
  const auto areas = face_areas(p);
  const double largest = *std::max_element(areas.begin(), areas.end());
  return largest > 0. ? 3. * std::abs(tet_volume(p[0], p[1], p[2], p[3])) / largest : 0.;
}

MeshQuality measure_quality(const TetMesh& mesh) {
  if (mesh.cells.empty())
    throw Error("The quality of a mesh without cells is not defined; mesh a mask first.");
  MeshQuality result;
  result.n_cells = mesh.cells.size();
  result.n_nodes = mesh.points.size();
  result.min_quality = result.min_edge = result.min_height =
      std::numeric_limits<double>::infinity();
  std::size_t n_below = 0;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const Corners p = cell_corners(mesh, c);
    const double quality = radius_ratio(p), height = min_height(p);
    const auto edges = edge_lengths(p);
    result.min_quality = std::min(result.min_quality, quality);
    result.mean_quality += quality;
    n_below += quality < 0.2;
    result.volume_mm3 += tet_volume(p[0], p[1], p[2], p[3]);
    result.min_height = std::min(result.min_height, height);
    const auto [shortest, longest] = std::minmax_element(edges.begin(), edges.end());
    result.min_edge = std::min(result.min_edge, *shortest);
    for (const double edge : edges)
      result.mean_edge += edge / 6.;
    result.max_aspect = std::max(result.max_aspect, *longest / std::max(height, 1e-12 * *longest));
  }
  result.mean_quality /= double(result.n_cells);
  result.mean_edge /= double(result.n_cells);
  result.fraction_below_02 = double(n_below) / double(result.n_cells);
  return result;
}

} // namespace prosup::mesh
