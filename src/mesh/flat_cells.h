#ifndef PROSUP_MESH_FLAT_CELLS_H
#define PROSUP_MESH_FLAT_CELLS_H

#include "prosup/mesh/tet_mesh.h"

namespace prosup::mesh {

/// Takes away cells lower than `least_height` (mm) that lie flat under the surface,
/// two of their faces being neighbours in it at an angle of less than 30 degrees:
/// the other two faces take their place, as if the edge between them were flipped.
/// Near corners, moving nodes cannot repair such cells. Returns their number.
unsigned peel_flat_cells(TetMesh& mesh, double least_height);

} // namespace prosup::mesh

#endif
