#ifndef PROSUP_SRC_OUTPUT_MESH_CHECKS_H
#define PROSUP_SRC_OUTPUT_MESH_CHECKS_H

#include <string>
#include <vector>

#include "prosup/mesh/tet_mesh.h"

namespace prosup::output {

/// @throws Error if a mesh is inconsistent or a position is not finite.
void check_mesh(const mesh::UnloadedMesh& mesh, const std::string& name);

/// J of each cell. @throws Error if a cell has no volume in the unloaded configuration.
std::vector<double> checked_jacobians(const mesh::UnloadedMesh& mesh, const std::string& name);

} // namespace prosup::output

#endif
