#include "prosup/evaluation/point_mapper.h"

#include <deal.II/base/symmetric_tensor.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "prosup/core/error.h"
#include "surface_locator.h"
#include "tet_locator.h"

namespace prosup::evaluation {

namespace {

using Face = SurfaceLocator::Face;

/// The surface of a mesh.
struct Surface {
  std::vector<Face> faces;
  std::vector<unsigned> cells; ///< behind each face
};

/// The faces that belong to one cell only.
Surface surface_of(const std::vector<std::array<unsigned, 4>>& cells) {
  struct Side {
    Face face;
    unsigned cell;
  };
  std::vector<Side> sides;
  sides.reserve(4 * cells.size());
  for (unsigned i = 0; i < cells.size(); ++i) {
    const auto& c = cells[i];
    for (Face face : {Face{c[1], c[2], c[3]}, Face{c[0], c[2], c[3]}, Face{c[0], c[1], c[3]},
                      Face{c[0], c[1], c[2]}}) {
      std::sort(face.begin(), face.end());
      sides.push_back({face, i});
    }
  }
  std::sort(sides.begin(), sides.end(),
            [](const Side& a, const Side& b) { return a.face < b.face; });
  Surface surface;
  for (std::size_t f = 0; f < sides.size(); ++f) {
    const bool shared = (f > 0 && sides[f].face == sides[f - 1].face) ||
                        (f + 1 < sides.size() && sides[f].face == sides[f + 1].face);
    if (shared)
      continue;
    surface.faces.push_back(sides[f].face);
    surface.cells.push_back(sides[f].cell);
  }
  return surface;
}

bool is_finite(const Point<3>& p) {
  return std::isfinite(p[0] + p[1] + p[2]);
}

void require_finite(const Point<3>& point) {
  if (!is_finite(point))
    throw Error("A point to be mapped has a coordinate that is not a finite number; coordinates "
                "are LPS, mm.");
}

void check(const mesh::UnloadedMesh& mesh) {
  const auto& nodes = mesh.mesh.points;
  if (mesh.mesh.cells.empty())
    throw Error("Points cannot be mapped with a mesh that has no cells; give the mesh of an "
                "unloading that finished.");
  if (nodes.size() != mesh.unloaded.size())
    throw Error("The mesh has " + std::to_string(nodes.size()) + " nodes but " +
                std::to_string(mesh.unloaded.size()) +
                " unloaded positions; give one for each node.");
  if (!std::all_of(nodes.begin(), nodes.end(), is_finite) ||
      !std::all_of(mesh.unloaded.begin(), mesh.unloaded.end(), is_finite))
    throw Error("The mesh has node positions that are not finite numbers, so that no point can be "
                "mapped with it; repeat the unloading.");
}

constexpr double inverse_tolerance = 1e-4; // mm
constexpr unsigned max_iterations = 30;

} // namespace

/// The cells of a mesh, and the faces of its surface, which are listed when they are first needed.
class PointMapper::Topology {
public:
  explicit Topology(TetLocator::Cells cells) : cells_(std::move(cells)) {}
  const TetLocator::Cells& cells() const { return cells_; }
  const Surface& surface() const {
    std::call_once(once_, [this] { surface_ = surface_of(cells_); });
    return surface_;
  }

private:
  TetLocator::Cells cells_;
  mutable std::once_flag once_;
  mutable Surface surface_;
};

/// The mesh in one configuration. Finds the tetrahedron that contains a point, or the closest
/// triangle of the surface, each with a locator that is made when it is first needed.
class PointMapper::PlacedMesh {
public:
  /// A point outside the mesh, mapped to the other configuration.
  struct Outside {
    Point<3> position;
    Tensor<2, 3> gradient; ///< of the position
    std::size_t face;      ///< the closest one
    double distance;
  };

  PlacedMesh(const std::vector<Point<3>>& nodes, const Topology& topology)
      : nodes_(nodes), topology_(topology) {}

  /// The position of `p` in `other`, or nothing if it is outside the mesh.
  std::optional<Point<3>> map_inside(const Point<3>& p, const PlacedMesh& other) const {
    const auto hit = cell_locator().find(p);
    if (!hit)
      return {};
    Point<3> mapped = p;
    for (unsigned a = 0; a < 4; ++a)
      mapped += hit->weights[a] * displacement(topology_.cells()[hit->cell][a], other);
    return mapped;
  }

  /// The position of `p` in `other` if it moves with the closest point of the surface. The
  /// search starts at `face`.
  Outside map_outside(const Point<3>& p, const PlacedMesh& other, std::size_t face = 0) const {
    const SurfaceLocator::Hit hit = surface_locator().closest(p, face);
    Outside mapped{p, Tensor<2, 3>(dealii::unit_symmetric_tensor<3>()), hit.face,
                   std::sqrt(hit.squared_distance)};
    for (unsigned a = 0; a < 3; ++a) {
      const Tensor<1, 3> u = displacement(topology_.surface().faces[hit.face][a], other);
      mapped.position += hit.weights[a] * u;
      mapped.gradient += dealii::outer_product(u, hit.gradients[a]);
    }
    return mapped;
  }

  /// As PointMapper::place(), if this is the unloaded and `other` the loaded mesh.
  MeshPlace place(const Point<3>& p, const PlacedMesh& other) const {
    if (const auto hit = cell_locator().find(p)) {
      const auto& cell = topology_.cells()[hit->cell];
      const Tensor<2, 3> F = gradient(cell, other);
      return {cell, hit->weights, F, determinant(F)};
    }
    const SurfaceLocator::Hit hit = surface_locator().closest(p);
    const Face& face = topology_.surface().faces[hit.face];
    return {{face[0], face[1], face[2], face[2]},
            {hit.weights[0], hit.weights[1], hit.weights[2], 0.},
            map_outside(p, other, hit.face).gradient,
            determinant(gradient(topology_.cells()[topology_.surface().cells[hit.face]], other))};
  }

  std::size_t n_nodes() const { return nodes_.size(); }

private:
  Tensor<2, 3> gradient(const std::array<unsigned, 4>& cell, const PlacedMesh& other) const {
    Tensor<2, 3> here, there; // columns are edges
    for (unsigned b = 0; b < 3; ++b)
      for (unsigned c = 0; c < 3; ++c) {
        here[c][b] = nodes_[cell[b + 1]][c] - nodes_[cell[0]][c];
        there[c][b] = other.nodes_[cell[b + 1]][c] - other.nodes_[cell[0]][c];
      }
    return there * invert(here);
  }

  Tensor<1, 3> displacement(unsigned node, const PlacedMesh& other) const {
    return other.nodes_[node] - nodes_[node];
  }

  const TetLocator& cell_locator() const {
    std::call_once(cells_once_, [this] { cell_locator_.emplace(nodes_, topology_.cells()); });
    return *cell_locator_;
  }

  const SurfaceLocator& surface_locator() const {
    std::call_once(surface_once_,
                   [this] { surface_locator_.emplace(nodes_, topology_.surface().faces); });
    return *surface_locator_;
  }

  std::vector<Point<3>> nodes_;
  const Topology& topology_;
  mutable std::once_flag cells_once_, surface_once_;
  mutable std::optional<TetLocator> cell_locator_;
  mutable std::optional<SurfaceLocator> surface_locator_;
};

PointMapper::PointMapper(const mesh::UnloadedMesh& mesh) {
  check(mesh);
  topology_ = std::make_unique<Topology>(mesh.mesh.cells);
  loaded_ = std::make_unique<PlacedMesh>(mesh.mesh.points, *topology_);
  unloaded_ = std::make_unique<PlacedMesh>(mesh.unloaded, *topology_);
}

PointMapper::~PointMapper() = default;
PointMapper::PointMapper(PointMapper&&) noexcept = default;
PointMapper& PointMapper::operator=(PointMapper&&) noexcept = default;

std::size_t PointMapper::n_nodes() const {
  return unloaded_->n_nodes();
}

MeshPlace PointMapper::place(const Point<3>& unloaded) const {
  require_finite(unloaded);
  return unloaded_->place(unloaded, *loaded_);
}

MappedPoint PointMapper::map(const Point<3>& point, Configuration from) const {
  require_finite(point);
  const PlacedMesh& here = from == Configuration::loaded ? *loaded_ : *unloaded_;
  const PlacedMesh& there = from == Configuration::loaded ? *unloaded_ : *loaded_;
  if (const auto mapped = here.map_inside(point, there))
    return {*mapped, 0.};
  const PlacedMesh::Outside mapped = here.map_outside(point, there);
  if (from == Configuration::unloaded)
    return {mapped.position, mapped.distance};
  return {inverse_outside(point, mapped.position, mapped.face), mapped.distance};
}

Point<3> PointMapper::inverse_outside(const Point<3>& loaded, const Point<3>& guess,
                                      std::size_t face) const {
  Point<3> best = guess, unloaded = guess;
  double least = std::numeric_limits<double>::max();
  for (unsigned i = 0; i < max_iterations && least > inverse_tolerance; ++i) {
    Tensor<2, 3> gradient = dealii::unit_symmetric_tensor<3>(); // in the mesh a plain step will do
    std::optional<Point<3>> mapped = unloaded_->map_inside(unloaded, *loaded_);
    if (!mapped) {
      const PlacedMesh::Outside beside = unloaded_->map_outside(unloaded, *loaded_, face);
      mapped = beside.position;
      face = beside.face;
      gradient = beside.gradient;
    }
    const Tensor<1, 3> missing = loaded - *mapped;
    const bool falls = missing.norm() < least;
    if (falls) {
      least = missing.norm();
      best = unloaded;
    }
    unloaded += falls && determinant(gradient) > 0.1 ? invert(gradient) * missing : missing;
  }
  return best;
}

} // namespace prosup::evaluation
