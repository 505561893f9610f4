#include "prosup/mesh/deformation.h"

#include <algorithm>
#include <limits>

namespace prosup::mesh {

double jacobian(const UnloadedMesh& mesh, std::size_t cell) {
  const auto& corners = mesh.mesh.cells[cell];
  const auto volume = [&](const std::vector<Point<3>>& nodes) {
    return tet_volume(nodes[corners[0]], nodes[corners[1]], nodes[corners[2]], nodes[corners[3]]);
  };
  return volume(mesh.mesh.points) / volume(mesh.unloaded);
}

JacobianRange jacobian_range(const UnloadedMesh& mesh) {
  JacobianRange range{std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest()};
  for (std::size_t cell = 0; cell < mesh.mesh.cells.size(); ++cell) {
    const double J = jacobian(mesh, cell);
    range = {std::min(range.min, J), std::max(range.max, J)};
  }
  return range;
}

std::vector<Point<3>> at_nodes(const TetMesh& mesh,
                               const std::vector<std::array<Point<3>, 4>>& at_cells) {
  std::vector<Point<3>> values(mesh.points);
  for (std::size_t cell = 0; cell < at_cells.size(); ++cell)
    for (unsigned a = 0; a < 4; ++a)
      values[mesh.cells[cell][a]] = at_cells[cell][a];
  return values;
}

} // namespace prosup::mesh
