#ifndef PROSUP_MESH_DEFORMATION_H
#define PROSUP_MESH_DEFORMATION_H

#include <array>
#include <cstddef>
#include <vector>

#include "prosup/mesh/tet_mesh.h"

namespace prosup::mesh {

/// J = det dx/dX of a linear cell: the signed ratio of its loaded to its unloaded volume.
double jacobian(const UnloadedMesh& mesh, std::size_t cell);

/// Smallest and largest J of all cells.
struct JacobianRange {
  double min, max;
};
JacobianRange jacobian_range(const UnloadedMesh& mesh);

/// Positions at the nodes of a mesh from those at the corners of its cells. A node without a
/// cell gets its position in the mesh.
std::vector<Point<3>> at_nodes(const TetMesh& mesh,
                               const std::vector<std::array<Point<3>, 4>>& at_cells);

} // namespace prosup::mesh

#endif
