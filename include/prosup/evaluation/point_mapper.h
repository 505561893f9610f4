#ifndef PROSUP_EVALUATION_POINT_MAPPER_H
#define PROSUP_EVALUATION_POINT_MAPPER_H

#include <cstddef>
#include <memory>

#include "prosup/mesh/tet_mesh.h"

namespace prosup::evaluation {

using dealii::Point;

/// One of the two configurations of an UnloadedMesh.
enum class Configuration { loaded, unloaded };

/// A point in the other configuration, and how far outside the mesh it was in
/// its own (mm; 0 inside).
struct MappedPoint {
  Point<3> position;
  double distance_outside;
};

/// Maps points between the loaded and the unloaded configuration of one breast.
///
/// In the mesh the map is that of the linear elements: the barycentric weights
/// of the tetrahedron that holds the point are applied to its corners in the
/// other configuration. Outside, an unloaded point X moves with the closest point c of
/// the mesh surface, X + d(c), which continues the map without a jump, and a loaded one to
/// where that map comes from, so that the two are inverse to each other; where the
/// inverse is not found (in folds of the skin) to the nearest point tried.
///
/// Queries may be made from several threads at once.
class PointMapper {
public:
  /// @throws Error if the mesh has no cells, if `unloaded` has another length
  /// than the nodes, or if a coordinate is not finite.
  explicit PointMapper(const mesh::UnloadedMesh& mesh);
  ~PointMapper();
  PointMapper(PointMapper&&) noexcept;
  PointMapper& operator=(PointMapper&&) noexcept;

  /// Maps a point given in the configuration `from` to the other one.
  /// @throws Error if the point is not finite.
  MappedPoint map(const Point<3>& point, Configuration from) const;

  Point<3> to_unloaded(const Point<3>& loaded) const {
    return map(loaded, Configuration::loaded).position;
  }
  Point<3> to_loaded(const Point<3>& unloaded) const {
    return map(unloaded, Configuration::unloaded).position;
  }

  /// Distance from a point to the mesh in a configuration, mm; 0 inside.
  double distance_outside(const Point<3>& point, Configuration configuration) const {
    return map(point, configuration).distance_outside;
  }

private:
  class PlacedMesh;

  /// X near `guess` with X + d(c(X)) = loaded, by Newton's method where it serves; `face` of
  /// the surface is near c.
  Point<3> inverse_outside(const Point<3>& loaded, const Point<3>& guess, std::size_t face) const;

  std::unique_ptr<PlacedMesh> loaded_, unloaded_;
};

} // namespace prosup::evaluation

#endif
