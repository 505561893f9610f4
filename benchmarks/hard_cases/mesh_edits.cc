#include "mesh_edits.h"

#include <algorithm>
#include <map>

#include "prosup/mesh/quality.h"

namespace prosup::benchmarks {

using namespace dealii;
using mesh::BoundaryPart;
using mesh::TetMesh;

namespace {

double volume(const TetMesh& mesh, const std::array<unsigned, 4>& cell) {
  return mesh::tet_volume(mesh.points[cell[0]], mesh.points[cell[1]], mesh.points[cell[2]],
                          mesh.points[cell[3]]);
}

double aspect_ratio(const std::array<Point<3>, 4>& corners) {
  double longest = 0.;
  for (unsigned a = 0; a < 4; ++a)
    for (unsigned b = 0; b < a; ++b)
      longest = std::max(longest, corners[a].distance(corners[b]));
  return longest / mesh::min_height(corners);
}

/// Sorted by node number, so that neighbouring prisms cut their common side alike.
void add_prism(TetMesh& mesh, std::array<unsigned, 3> face, const std::vector<unsigned>& outer,
               unsigned label) {
  std::sort(face.begin(), face.end());
  const auto [a, b, c] = face;
  for (std::array<unsigned, 4> cell : {std::array<unsigned, 4>{a, b, c, outer[c]},
                                       std::array<unsigned, 4>{a, b, outer[b], outer[c]},
                                       std::array<unsigned, 4>{a, outer[a], outer[b], outer[c]}}) {
    if (volume(mesh, cell) < 0.)
      std::swap(cell[2], cell[3]);
    mesh.cells.push_back(cell);
    mesh.tissue.push_back(static_cast<std::uint8_t>(label));
  }
}

/// Edges of the faces that are no skin, with their part.
std::map<std::pair<unsigned, unsigned>, BoundaryPart> edges_of_other_parts(const TetMesh& mesh) {
  std::map<std::pair<unsigned, unsigned>, BoundaryPart> edges;
  for (const mesh::BoundaryFace& face : mesh.boundary_faces)
    for (unsigned a = 0; face.part != BoundaryPart::skin && a < 3; ++a)
      edges[std::minmax(face.nodes[a], face.nodes[(a + 1) % 3])] = face.part;
  return edges;
}

} // namespace

unsigned make_slivers(TetMesh& mesh, double aspect, unsigned n_wanted) {
  std::vector<std::vector<unsigned>> cells_at(mesh.points.size());
  std::vector<bool> is_free(mesh.points.size(), true);
  for (unsigned c = 0; c < mesh.cells.size(); ++c)
    for (const unsigned node : mesh.cells[c])
      cells_at[node].push_back(c);
  for (const mesh::BoundaryFace& face : mesh.boundary_faces)
    for (const unsigned node : face.nodes)
      is_free[node] = false;

  unsigned n_made = 0;
  for (unsigned node = 0; node < mesh.points.size() && n_made < n_wanted; ++node) {
    if (!is_free[node])
      continue;
    const Point<3> before = mesh.points[node];
    for (const unsigned c : cells_at[node]) {
      Point<3> foot; // a point of the opposite face; its centre
      for (const unsigned other : mesh.cells[c])
        if (other != node)
          foot += Tensor<1, 3>(mesh.points[other]) / 3.;
      double part = 1.; // of the way left
      for (unsigned i = 0; i < 60 && aspect_ratio(cell_corners(mesh, c)) < aspect; ++i)
        mesh.points[node] = foot + (part *= 0.9) * (before - foot);
      const bool is_valid =
          std::all_of(cells_at[node].begin(), cells_at[node].end(), [&](unsigned n) {
            return volume(mesh, mesh.cells[n]) > 0. &&
                   aspect_ratio(cell_corners(mesh, n)) < 1.2 * aspect;
          });
      if (is_valid) {
        ++n_made;
        for (const unsigned n : cells_at[node]) // leave the neighbourhood alone
          for (const unsigned other : mesh.cells[n])
            is_free[other] = false;
        break;
      }
      mesh.points[node] = before;
    }
  }
  return n_made;
}

void grow_skin(TetMesh& mesh, double thickness, unsigned label) {
  std::vector<Tensor<1, 3>> normals(mesh.points.size());
  std::vector<mesh::BoundaryFace> skin, others;
  for (const mesh::BoundaryFace& face : mesh.boundary_faces)
    (face.part == BoundaryPart::skin ? skin : others).push_back(face);
  for (const mesh::BoundaryFace& face : skin) {
    const Point<3>& x = mesh.points[face.nodes[0]];
    const Tensor<1, 3> normal =
        cross_product_3d(mesh.points[face.nodes[1]] - x, mesh.points[face.nodes[2]] - x);
    for (const unsigned node : face.nodes)
      normals[node] += normal;
  }
  std::vector<unsigned> outer(mesh.points.size());
  const std::size_t n_before = mesh.points.size();
  for (unsigned node = 0; node < n_before; ++node)
    if (normals[node].norm() > 0.) {
      outer[node] = static_cast<unsigned>(mesh.points.size());
      mesh.points.push_back(mesh.points[node] + thickness / normals[node].norm() * normals[node]);
    }
  const auto borders = edges_of_other_parts(mesh);
  mesh.boundary_faces = others;
  for (const mesh::BoundaryFace& face : skin) {
    add_prism(mesh, face.nodes, outer, label);
    const auto [a, b, c] = face.nodes;
    mesh.boundary_faces.push_back({{outer[a], outer[b], outer[c]}, BoundaryPart::skin});
    for (unsigned i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax(face.nodes[i], face.nodes[(i + 1) % 3]);
      if (const auto border = borders.find({low, high}); border != borders.end()) {
        mesh.boundary_faces.push_back({{low, high, outer[high]}, border->second});
        mesh.boundary_faces.push_back({{low, outer[low], outer[high]}, border->second});
      }
    }
  }
}

} // namespace prosup::benchmarks
