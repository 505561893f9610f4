#ifndef PROSUP_MESH_BOUNDARY_CODES_H
#define PROSUP_MESH_BOUNDARY_CODES_H

#include <cstdint>
#include <vector>

#include "prosup/mesh/tet_mesh.h"

namespace prosup::mesh {

/// The boundary faces of a mesh as one number for each cell, as stored in files. Each face of
/// the cell has two bits, the lowest for the face opposite to corner 0. They hold the number
/// of its BoundaryPart, or 0 in the interior.
std::vector<std::uint8_t> boundary_codes(const TetMesh& mesh);

/// The boundary faces from the codes of all cells, with outward normals.
std::vector<BoundaryFace> boundary_faces(const TetMesh& mesh,
                                         const std::vector<std::uint8_t>& codes);

} // namespace prosup::mesh

#endif
