#ifndef PROSUP_MESH_BOUNDARY_CODES_H
#define PROSUP_MESH_BOUNDARY_CODES_H

#include <cstdint>
#include <vector>

#include "prosup/mesh/tet_mesh.h"

namespace prosup::mesh {

/// The boundary faces of a mesh as one number for each cell, as files keep it:
/// two bits for each of its faces, the lowest for that opposite to corner 0,
/// with the number of its BoundaryPart, or 0 for a face in the interior.
std::vector<std::uint8_t> boundary_codes(const TetMesh& mesh);

/// The boundary faces from the codes of all cells, outward.
std::vector<BoundaryFace> boundary_faces(const TetMesh& mesh,
                                         const std::vector<std::uint8_t>& codes);

} // namespace prosup::mesh

#endif
