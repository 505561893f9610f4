#include "prosup/mechanics/body/boundary.h"

#include <algorithm>

namespace prosup::mechanics {

using namespace dealii;

namespace {

/// Parts of the area of a quadratic face.
constexpr double area_at_corner = 1. / 12., area_at_edge = 1. / 4.;

} // namespace

std::vector<std::size_t> faces_on_boundary(const Body& body, const BoundaryIds& ids,
                                           const FaceFilter& counts) {
  const auto passes = [&](const BoundaryFace& face) {
    const auto corner = [&](unsigned v) {
      return node_value(body.vertex_positions(), face.nodes[v]);
    };
    const Tensor<1, 3> normal = cross_product_3d(corner(1) - corner(0), corner(2) - corner(0));
    return counts((corner(0) + corner(1) + corner(2)) / 3., normal / normal.norm());
  };
  std::vector<std::size_t> faces;
  const auto& all = body.boundary_faces();
  for (std::size_t i = 0; i < all.size(); ++i)
    if (ids.count(all[i].id) > 0 && (!counts || passes(all[i])))
      faces.push_back(i);
  return faces;
}

std::vector<bool> nodes_on_boundary(const Body& body, const BoundaryIds& ids,
                                    const FaceFilter& counts) {
  std::vector<double> marks(body.n_local_nodes(), 0.);
  for (const std::size_t i : faces_on_boundary(body, ids, counts))
    for (const unsigned node : body.boundary_faces()[i].nodes)
      marks[node] = 1.;
  // A node may touch the boundary only through an element of another rank.
  marks = sum_over_ranks(body, marks);
  std::vector<bool> on_boundary(body.n_local_nodes());
  std::transform(marks.begin(), marks.end(), on_boundary.begin(),
                 [](double mark) { return mark > 0.; });
  return on_boundary;
}

std::vector<double> lumped_area(const Body& body, const std::vector<std::size_t>& faces,
                                const NodeVector& positions) {
  std::vector<double> area(body.n_local_nodes(), 0.);
  for (const std::size_t i : faces) {
    const BoundaryFace& face = body.boundary_faces()[i];
    const auto corner = [&](unsigned v) { return node_value(positions, face.nodes[v]); };
    const double total =
        0.5 * cross_product_3d(corner(1) - corner(0), corner(2) - corner(0)).norm();
    for (unsigned v = 0; v < face.nodes.size(); ++v)
      area[face.nodes[v]] += total * (face.nodes.size() == 3 ? 1. / 3.
                                      : v < 3                ? area_at_corner
                                                             : area_at_edge);
  }
  return sum_over_ranks(body, area);
}

std::vector<double> lumped_area(const Body& body, const BoundaryIds& ids,
                                const NodeVector& positions) {
  return lumped_area(body, faces_on_boundary(body, ids), positions);
}

} // namespace prosup::mechanics
