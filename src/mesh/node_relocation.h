#ifndef PROSUP_MESH_NODE_RELOCATION_H
#define PROSUP_MESH_NODE_RELOCATION_H

#include "prosup/mesh/tet_mesh.h"
#include "surface_projection.h"

namespace prosup::mesh {

/// Moves the nodes of cells whose smallest height is below `wanted_height` (mm) or
/// whose radius ratio is below 0.4, so that the worst cell around each of them
/// gets better: the smallest height rules the critical time step. Nodes of the
/// surface slide on their patches; unlike an optimiser that holds the surface
/// fixed this mends the flat cells of thin layers. `patches[i]` is the set of
/// patches of node i; nodes beyond the end of the vector lie in the interior.
void improve_worst_cells(TetMesh& mesh, const std::vector<unsigned>& patches,
                         const SurfaceProjection& projection, double wanted_height);

} // namespace prosup::mesh

#endif
