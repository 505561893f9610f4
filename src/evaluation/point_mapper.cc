#include "prosup/evaluation/point_mapper.h"

#include <vtkCellArray.h>
#include <vtkGenericCell.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStaticCellLocator.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "prosup/core/error.h"
#include "tet_locator.h"

namespace prosup::evaluation {

namespace {

using Face = std::array<unsigned, 3>;

/// The faces that belong to one cell only: the surface of the mesh.
std::vector<Face> surface_faces(const std::vector<std::array<unsigned, 4>>& cells) {
  std::vector<Face> faces, surface;
  faces.reserve(4 * cells.size());
  for (const auto& c : cells)
    for (Face face : {Face{c[1], c[2], c[3]}, Face{c[0], c[2], c[3]}, Face{c[0], c[1], c[3]},
                      Face{c[0], c[1], c[2]}}) {
      std::sort(face.begin(), face.end());
      faces.push_back(face);
    }
  std::sort(faces.begin(), faces.end());
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const bool shared =
        (f > 0 && faces[f] == faces[f - 1]) || (f + 1 < faces.size() && faces[f] == faces[f + 1]);
    if (!shared)
      surface.push_back(faces[f]);
  }
  return surface;
}

bool is_finite(const Point<3>& p) {
  return std::isfinite(p[0] + p[1] + p[2]);
}

void check(const mesh::UnloadedMesh& mesh) {
  const auto& nodes = mesh.mesh.points;
  if (mesh.mesh.cells.empty())
    throw Error("Points cannot be mapped with a mesh that has no cells; give the mesh of an "
                "unloading that finished.");
  if (nodes.size() != mesh.unloaded.size())
    throw Error("The mesh has " + std::to_string(nodes.size()) + " nodes but " +
                std::to_string(mesh.unloaded.size()) +
                " unloaded positions; both must be as many.");
  if (!std::all_of(nodes.begin(), nodes.end(), is_finite) ||
      !std::all_of(mesh.unloaded.begin(), mesh.unloaded.end(), is_finite))
    throw Error("The mesh has node positions that are not finite numbers, so that no point can be "
                "mapped with it; repeat the unloading.");
}

constexpr double inverse_tolerance = 1e-4; // mm
constexpr unsigned max_iterations = 30;

/// Scratch memory of VTK's locators, one per thread because they write to it.
vtkGenericCell* thread_cell() {
  thread_local vtkNew<vtkGenericCell> cell;
  return cell;
}

} // namespace

/// The mesh in one configuration: finds the tetrahedron at a point, or the
/// surface triangle closest to it.
class PointMapper::Configuration {
public:
  Configuration(const std::vector<Point<3>>& nodes, const TetLocator::Cells& cells,
                const std::vector<Face>& surface)
      : nodes_(nodes), cells_(cells), surface_(surface), cell_locator_(nodes, cells) {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->SetNumberOfPoints(static_cast<vtkIdType>(nodes.size()));
    for (std::size_t i = 0; i < nodes.size(); ++i)
      points->SetPoint(static_cast<vtkIdType>(i), nodes[i][0], nodes[i][1], nodes[i][2]);
    vtkNew<vtkCellArray> triangles;
    for (const Face& face : surface)
      triangles->InsertNextCell({face[0], face[1], face[2]});
    vtkNew<vtkPolyData> boundary;
    boundary->SetPoints(points);
    boundary->SetPolys(triangles);
    surface_locator_->SetDataSet(boundary);
    surface_locator_->BuildLocator();
  }

  /// Where `p` goes with the mesh to the configuration `other`.
  MappedPoint map(const Point<3>& p, const Configuration& other) const {
    if (const auto hit = cell_locator_.find(p))
      return {p + displacement(cells_[hit->cell], hit->weights, other), 0.};
    return map_outside(p, other);
  }

private:
  template <std::size_t n>
  Tensor<1, 3> displacement(const std::array<unsigned, n>& corners,
                            const std::array<double, n>& weights,
                            const Configuration& other) const {
    Tensor<1, 3> result;
    for (std::size_t a = 0; a < n; ++a)
      result += weights[a] * (other.nodes_[corners[a]] - nodes_[corners[a]]);
    return result;
  }

  MappedPoint map_outside(const Point<3>& p, const Configuration& other) const {
    const double x[3] = {p[0], p[1], p[2]};
    double closest[3], squared_distance = 0.;
    vtkIdType face = -1;
    int unused = 0;
    vtkGenericCell* triangle = thread_cell();
    surface_locator_->FindClosestPoint(x, closest, triangle, face, unused, squared_distance);
    // The search leaves the last triangle it looked at, not the closest one.
    surface_locator_->GetDataSet()->GetCell(face, triangle);
    std::array<double, 3> weights{};
    double parametric[3], in_plane[3], off_plane = 0.;
    triangle->EvaluatePosition(closest, in_plane, unused, parametric, off_plane, weights.data());
    return {p + displacement(surface_[static_cast<std::size_t>(face)], weights, other),
            std::sqrt(squared_distance)};
  }

  std::vector<Point<3>> nodes_;
  TetLocator::Cells cells_;
  std::vector<Face> surface_;
  TetLocator cell_locator_;
  vtkNew<vtkStaticCellLocator> surface_locator_;
};

PointMapper::PointMapper(const mesh::UnloadedMesh& mesh) {
  check(mesh);
  const auto& cells = mesh.mesh.cells;
  const std::vector<Face> surface = surface_faces(cells);
  loaded_ = std::make_unique<Configuration>(mesh.mesh.points, cells, surface);
  unloaded_ = std::make_unique<Configuration>(mesh.unloaded, cells, surface);
}

PointMapper::~PointMapper() = default;
PointMapper::PointMapper(PointMapper&&) noexcept = default;
PointMapper& PointMapper::operator=(PointMapper&&) noexcept = default;

MappedPoint PointMapper::map(const Point<3>& point, State from) const {
  if (!is_finite(point))
    throw Error("A point to be mapped has a coordinate that is not a finite number; coordinates "
                "are LPS, mm.");
  const Configuration& here = from == State::loaded ? *loaded_ : *unloaded_;
  const Configuration& there = from == State::loaded ? *unloaded_ : *loaded_;
  MappedPoint mapped = here.map(point, there);
  if (from == State::loaded && mapped.distance_outside > 0.)
    mapped.position = inverse_outside(point, mapped.position);
  return mapped;
}

Point<3> PointMapper::inverse_outside(const Point<3>& loaded, const Point<3>& guess) const {
  Point<3> best = guess, unloaded = guess;
  double least = std::numeric_limits<double>::max();
  for (unsigned i = 0; i < max_iterations && least > inverse_tolerance; ++i) {
    const Tensor<1, 3> missing = loaded - unloaded_->map(unloaded, *loaded_).position;
    if (missing.norm() < least) {
      least = missing.norm();
      best = unloaded;
    }
    unloaded += missing;
  }
  return best;
}

} // namespace prosup::evaluation
