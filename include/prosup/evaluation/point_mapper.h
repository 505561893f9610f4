#ifndef PROSUP_EVALUATION_POINT_MAPPER_H
#define PROSUP_EVALUATION_POINT_MAPPER_H

#include <deal.II/base/tensor.h>

#include <array>
#include <cstddef>
#include <memory>

#include "prosup/mesh/tet_mesh.h"

namespace prosup::evaluation {

using dealii::Point;

/// One of the two configurations of an UnloadedMesh.
enum class Configuration { loaded, unloaded };

/// Points that are further outside of a mesh than this are not part of the breast, mm. It is more
/// than the mesh's own error at the skin.
constexpr double far_outside = 2.;

/// Result of mapping a point.
struct MappedPoint {
  Point<3> position;       ///< in the other configuration, LPS mm
  double distance_outside; ///< from the given point to the mesh, mm; 0 inside
};

/// Where an unloaded point lies in a mesh.
struct MeshPlace {
  std::array<unsigned, 4> nodes; ///< with which it moves
  std::array<double, 4> weights; ///< of these nodes, sum 1
  dealii::Tensor<2, 3> gradient; ///< F = dx/dX there
  double volume_ratio;           ///< J of the cell there, or of that behind the closest triangle
};

/// Maps points between the loaded and the unloaded configuration of one breast.
///
/// Inside the mesh the map is that of the linear elements: the barycentric weights of a point
/// in its tetrahedron are applied to the corners in the other configuration. Outside, an
/// unloaded point X is mapped to X + u(c), where u(c) is the displacement of the closest point
/// c on the surface of the mesh; this continues the map without a jump. A loaded point is
/// mapped by the inverse of this. Where the inverse cannot be found, in folds of the skin, the
/// nearest point that was tried is returned.
///
/// May be used from several threads at once.
class PointMapper {
public:
  /// @throws Error if the mesh has no cells, if the number of unloaded positions is not that
  /// of the nodes, or if a coordinate is not finite.
  explicit PointMapper(const mesh::UnloadedMesh& mesh);
  ~PointMapper();
  PointMapper(PointMapper&&) noexcept;
  PointMapper& operator=(PointMapper&&) noexcept;

  /// Maps a point of the configuration `from` to the other one.
  /// @throws Error if the point is not finite.
  MappedPoint map(const Point<3>& point, Configuration from) const;

  /// The corners of the cell that holds an unloaded point, or of the closest triangle of the
  /// surface, the last node twice. @throws Error if the point is not finite.
  MeshPlace place(const Point<3>& unloaded) const;
  std::size_t n_nodes() const;

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
  class Topology;
  class PlacedMesh;

  /// Solves X + u(c(X)) = loaded for X near `guess`, by Newton's method where it converges.
  /// `face` is a face of the surface near c.
  Point<3> inverse_outside(const Point<3>& loaded, const Point<3>& guess, std::size_t face) const;

  std::unique_ptr<Topology> topology_;
  std::unique_ptr<PlacedMesh> loaded_, unloaded_;
};

} // namespace prosup::evaluation

#endif
