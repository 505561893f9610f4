#include "mesh_checks.h"

#include <cmath>

#include "prosup/core/error.h"
#include "prosup/mesh/deformation.h"

namespace prosup::output {

void check_mesh(const mesh::UnloadedMesh& mesh, const std::string& name) {
  const std::size_t n = mesh.mesh.points.size();
  if (mesh.unloaded.size() != n || mesh.mesh.tissue.size() != mesh.mesh.cells.size())
    throw Error("The mesh '" + name + "' has " + std::to_string(n) + " nodes with " +
                std::to_string(mesh.unloaded.size()) + " unloaded positions and " +
                std::to_string(mesh.mesh.cells.size()) + " cells with " +
                std::to_string(mesh.mesh.tissue.size()) + " tissues; both pairs must be equal.");
  for (std::size_t i = 0; i < n; ++i)
    for (unsigned d = 0; d < 3; ++d)
      if (!std::isfinite(mesh.mesh.points[i][d]) || !std::isfinite(mesh.unloaded[i][d]))
        throw Error("Node " + std::to_string(i) + " of the mesh '" + name +
                    "' has a position that is not a finite number; the mesh was not written.");
}

std::vector<double> checked_jacobians(const mesh::UnloadedMesh& mesh, const std::string& name) {
  std::vector<double> jacobians;
  for (std::size_t cell = 0; cell < mesh.mesh.cells.size(); ++cell) {
    jacobians.push_back(mesh::jacobian(mesh, cell));
    if (!std::isfinite(jacobians.back()))
      throw Error("Cell " + std::to_string(cell) + " of the mesh '" + name +
                  "' has no volume in the unloaded configuration; the mesh was not written.");
  }
  return jacobians;
}

} // namespace prosup::output
