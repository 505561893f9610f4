#include "prosup/evaluation/depth.h"

#include <cmath>
#include <set>

#include "surface_locator.h"

namespace prosup::evaluation {

namespace {

using Locator = std::optional<SurfaceLocator>;

Locator locator_of(const mesh::TetMesh& mesh, const std::vector<Point<3>>& nodes,
                   mesh::BoundaryPart part) {
  std::vector<SurfaceLocator::Face> faces;
  for (const mesh::BoundaryFace& face : mesh.boundary_faces)
    if (face.part == part)
      faces.push_back(face.nodes);
  return faces.empty() ? Locator() : Locator(std::in_place, nodes, faces);
}

std::optional<double> distance(const Locator& locator, const Point<3>& point) {
  if (!locator)
    return {};
  return std::sqrt(locator->closest(point).squared_distance);
}

} // namespace

struct DepthGauge::Parts {
  Locator skin, chest_wall;
};

DepthGauge::DepthGauge(const mesh::TetMesh& mesh, const std::vector<Point<3>>& nodes)
    : parts_(
          std::make_unique<Parts>(Parts{locator_of(mesh, nodes, mesh::BoundaryPart::skin),
                                        locator_of(mesh, nodes, mesh::BoundaryPart::chest_wall)})) {
}

DepthGauge::~DepthGauge() = default;
DepthGauge::DepthGauge(DepthGauge&&) noexcept = default;
DepthGauge& DepthGauge::operator=(DepthGauge&&) noexcept = default;

std::optional<Point<3>> tip_of(const mesh::TetMesh& mesh) {
  const Locator chest_wall = locator_of(mesh, mesh.points, mesh::BoundaryPart::chest_wall);
  std::set<unsigned> skin;
  for (const mesh::BoundaryFace& face : mesh.boundary_faces)
    if (face.part == mesh::BoundaryPart::skin)
      skin.insert(face.nodes.begin(), face.nodes.end());
  if (!chest_wall || skin.empty())
    return {};
  const auto depth = [&](unsigned node) {
    return chest_wall->closest(mesh.points[node]).squared_distance;
  };
  unsigned tip = *skin.begin();
  double furthest = depth(tip);
  for (const unsigned node : skin)
    if (const double here = depth(node); here > furthest) {
      furthest = here;
      tip = node;
    }
  return mesh.points[tip];
}

Depth DepthGauge::operator()(const Point<3>& point) const {
  return {distance(parts_->skin, point), distance(parts_->chest_wall, point)};
}

} // namespace prosup::evaluation
