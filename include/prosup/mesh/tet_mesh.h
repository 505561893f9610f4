#ifndef PROSUP_MESH_TET_MESH_H
#define PROSUP_MESH_TET_MESH_H

#include <deal.II/base/point.h>
#include <deal.II/base/types.h>

#include <array>
#include <cstdint>
#include <vector>

namespace prosup::mesh {

using dealii::Point;

/// What lies beyond a boundary face of a breast mesh. The numbers are the boundary ids of the
/// deal.II triangulation.
enum class BoundaryPart : unsigned { chest_wall = 1, cut_plane = 2, skin = 3 };

constexpr dealii::types::boundary_id boundary_id_of(BoundaryPart part) {
  return static_cast<dealii::types::boundary_id>(part);
}

/// A face of a cell that no other cell has.
struct BoundaryFace {
  std::array<unsigned, 3> nodes; ///< ordered so that the normal points outwards
  BoundaryPart part;
};

/// A whole tetrahedral mesh on one process, in the loaded configuration in which the breast
/// was imaged, prone or supine.
struct TetMesh {
  std::vector<Point<3>> points;               ///< loaded positions x, LPS mm
  std::vector<std::array<unsigned, 4>> cells; ///< positively oriented
  std::vector<std::uint8_t> tissue;           ///< label of each cell, see Labels
  std::vector<BoundaryFace> boundary_faces;
};

/// A TetMesh with both configurations: its nodes also have unloaded positions.
struct UnloadedMesh {
  TetMesh mesh;
  std::vector<Point<3>> unloaded; ///< X of each node, LPS mm
};

/// Volume of a tetrahedron with the given corners, mm^3; negative if inverted.
double tet_volume(const Point<3>& a, const Point<3>& b, const Point<3>& c, const Point<3>& d);

} // namespace prosup::mesh

#endif
