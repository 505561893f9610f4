#ifndef PROSUP_MESH_DEFORMATION_H
#define PROSUP_MESH_DEFORMATION_H

#include <cstddef>

#include "prosup/mesh/tet_mesh.h"

namespace prosup::mesh {

/// J = det dx/dX of a linear cell: its loaded over its unloaded volume, signed.
double jacobian(const UnloadedMesh& mesh, std::size_t cell);

/// Smallest J of all cells.
double min_jacobian(const UnloadedMesh& mesh);

} // namespace prosup::mesh

#endif
