#ifndef PROSUP_MESH_REFINE_H
#define PROSUP_MESH_REFINE_H

#include "prosup/mesh/tet_mesh.h"

namespace prosup::mesh {

/// Divides each cell into its eight `tet_children`, with new nodes in the middle of the edges.
/// Child c of cell i becomes cell 8 i + c, as in mechanics::Body for quadratic elements. Old
/// nodes keep their numbers; new nodes follow.
TetMesh refined(const TetMesh& mesh);

} // namespace prosup::mesh

#endif
