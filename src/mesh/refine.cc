#include "prosup/mesh/refine.h"

#include <algorithm>
#include <map>
#include <utility>

#include "prosup/core/tet_topology.h"

namespace prosup::mesh {

namespace {

/// Nodes in the middle of edges, made when first asked for.
class EdgeNodes {
public:
  explicit EdgeNodes(std::vector<Point<3>>& points) : points_(points) {}

  unsigned operator()(unsigned a, unsigned b) {
    const auto [found, is_new] =
        nodes_.emplace(std::minmax(a, b), static_cast<unsigned>(points_.size()));
    if (is_new)
      points_.push_back(points_[a] + 0.5 * (points_[b] - points_[a]));
    return found->second;
  }

private:
  std::vector<Point<3>>& points_;
  std::map<std::pair<unsigned, unsigned>, unsigned> nodes_;
};

} // namespace

TetMesh refined(const TetMesh& mesh) {
  TetMesh fine;
  fine.points = mesh.points;
  EdgeNodes edge_node(fine.points);
  for (std::size_t i = 0; i < mesh.cells.size(); ++i) {
    std::array<unsigned, 10> nodes;
    std::copy(mesh.cells[i].begin(), mesh.cells[i].end(), nodes.begin());
    for (unsigned e = 0; e < 6; ++e)
      nodes[4 + e] = edge_node(nodes[tet_edges[e][0]], nodes[tet_edges[e][1]]);
    for (const auto& child : tet_children)
      fine.cells.push_back({nodes[child[0]], nodes[child[1]], nodes[child[2]], nodes[child[3]]});
    fine.tissue.insert(fine.tissue.end(), 8, mesh.tissue[i]);
  }
  for (const BoundaryFace& face : mesh.boundary_faces) {
    const auto [a, b, c] = face.nodes;
    const unsigned ab = edge_node(a, b), bc = edge_node(b, c), ca = edge_node(c, a);
    for (const std::array<unsigned, 3>& nodes :
         {std::array<unsigned, 3>{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}})
      fine.boundary_faces.push_back({nodes, face.part});
  }
  return fine;
}

} // namespace prosup::mesh
