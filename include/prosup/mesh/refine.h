#ifndef PROSUP_MESH_REFINE_H
#define PROSUP_MESH_REFINE_H

#include "prosup/mesh/tet_mesh.h"

namespace prosup::mesh {

/// The mesh of the `tet_children` of all cells, with new nodes in the middle of
/// the edges: child c of cell i is cell 8 i + c, as in mechanics::Body for
/// quadratic elements. Points keep their numbers; new ones follow.
TetMesh refined(const TetMesh& mesh);

} // namespace prosup::mesh

#endif
