#include "prosup/mechanics/body/boundary.h"

#include <algorithm>

namespace prosup::mechanics {

using namespace dealii;

namespace {

/// Parts of the area of a quadratic face.
constexpr double area_at_corner = 1. / 12., area_at_edge = 1. / 4.;

/// function(centre, normal) of a face of the mesh.
template <typename Function>
auto at_centre(const Body& body, const BoundaryFace& face, const Function& function) {
  const auto corner = [&](unsigned v) {
    return node_value(body.vertex_positions(), face.nodes[v]);
  };
  const Tensor<1, 3> normal = cross_product_3d(corner(1) - corner(0), corner(2) - corner(0));
  return function((corner(0) + corner(1) + corner(2)) / 3., normal / normal.norm());
}

} // namespace

std::vector<std::size_t> faces_on_boundary(const Body& body, const BoundaryIds& ids,
                                           const FaceFilter& counts) {
  std::vector<std::size_t> faces;
  const auto& all = body.boundary_faces();
  for (std::size_t i = 0; i < all.size(); ++i)
    if (ids.count(all[i].id) > 0 && (!counts || at_centre(body, all[i], counts)))
      faces.push_back(i);
  return faces;
}

std::vector<double> values_at_faces(const Body& body, const std::vector<std::size_t>& faces,
                                    const FaceValue& value) {
  std::vector<double> values;
  for (const std::size_t i : faces)
    values.push_back(at_centre(body, body.boundary_faces()[i], value));
  return values;
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

double area_part(std::size_t n_nodes, std::size_t v) {
  if (n_nodes == 3)
    return 1. / 3.;
  return v < 3 ? area_at_corner : area_at_edge;
}

std::vector<double> lumped_area(const Body& body, const std::vector<std::size_t>& faces,
                                const NodeVector& positions, const std::vector<double>& weights) {
  std::vector<double> area(body.n_local_nodes(), 0.);
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const BoundaryFace& face = body.boundary_faces()[faces[i]];
    const auto corner = [&](unsigned v) { return node_value(positions, face.nodes[v]); };
    const double total = (weights.empty() ? 0.5 : 0.5 * weights[i]) *
                         cross_product_3d(corner(1) - corner(0), corner(2) - corner(0)).norm();
    for (unsigned v = 0; v < face.nodes.size(); ++v)
      area[face.nodes[v]] += total * area_part(face.nodes.size(), v);
  }
  return sum_over_ranks(body, area);
}

std::vector<double> lumped_area(const Body& body, const BoundaryIds& ids,
                                const NodeVector& positions) {
  return lumped_area(body, faces_on_boundary(body, ids), positions);
}

} // namespace prosup::mechanics
