#include "flat_cells.h"

#include <algorithm>
#include <set>

#include "boundary_faces.h"
#include "prosup/mesh/quality.h"

namespace prosup::mesh {

namespace {

using Edge = std::array<unsigned, 2>;

dealii::Tensor<1, 3> unit_normal(const TetMesh& mesh, const OuterFace& face) {
  const auto& x = mesh.points;
  const auto normal =
      cross_product_3d(x[face.nodes[1]] - x[face.nodes[0]], x[face.nodes[2]] - x[face.nodes[0]]);
  return normal / normal.norm();
}

std::set<Edge> edges_of(const std::vector<OuterFace>& faces) {
  std::set<Edge> edges;
  for (const OuterFace& face : faces)
    for (unsigned i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax(face.nodes[i], face.nodes[(i + 1) % 3]);
      edges.insert({low, high});
    }
  return edges;
}

/// The edge of a cell across from the one that two of its faces share: it joins
/// the corner that only `first` has and the one that only `second` has.
Edge opposite_edge(const OuterFace& first, const OuterFace& second) {
  const auto own_corner = [](const OuterFace& face, const OuterFace& other) {
    return *std::find_if(face.nodes.begin(), face.nodes.end(), [&](unsigned node) {
      return std::find(other.nodes.begin(), other.nodes.end(), node) == other.nodes.end();
    });
  };
  const auto [low, high] = std::minmax({own_corner(first, second), own_corner(second, first)});
  return {low, high};
}

} // namespace

unsigned peel_flat_cells(TetMesh& mesh, double least_height) {
  constexpr double cosine = 0.866;
  std::vector<OuterFace> faces = outer_faces(mesh);
  std::stable_sort(faces.begin(), faces.end(),
                   [](const OuterFace& a, const OuterFace& b) { return a.cell < b.cell; });
  std::set<Edge> edges = edges_of(faces);
  std::set<unsigned> touched; // neighbours wait for the next call
  std::vector<bool> peeled(mesh.cells.size(), false);
  for (std::size_t f = 0; f < faces.size();) {
    const unsigned c = faces[f].cell;
    std::size_t n = 1;
    while (f + n < faces.size() && faces[f + n].cell == c)
      ++n;
    const OuterFace &first = faces[f], &second = faces[f + n - 1];
    f += n;
    const auto& cell = mesh.cells[c];
    if (n != 2 || min_height(cell_corners(mesh, c)) >= least_height ||
        unit_normal(mesh, first) * unit_normal(mesh, second) < cosine ||
        std::any_of(cell.begin(), cell.end(), [&](unsigned v) { return touched.count(v) > 0; }) ||
        !edges.insert(opposite_edge(first, second)).second)
      continue;
    peeled[c] = true;
    touched.insert(cell.begin(), cell.end());
  }
  std::size_t n_kept = 0;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    if (!peeled[c])
      mesh.cells[n_kept++] = mesh.cells[c];
  const auto n_peeled = unsigned(mesh.cells.size() - n_kept);
  mesh.cells.resize(n_kept);
  return n_peeled;
}

} // namespace prosup::mesh
