#ifndef PROSUP_MESH_BOUNDARY_FACES_H
#define PROSUP_MESH_BOUNDARY_FACES_H

#include <vector>

#include "prosup/mesh/tet_mesh.h"

namespace prosup::mesh {

/// A face that only one cell has, corners in order so that the normal points outwards.
struct OuterFace {
  std::array<unsigned, 3> nodes;
  unsigned cell;
};

std::vector<OuterFace> outer_faces(const TetMesh& mesh);

} // namespace prosup::mesh

#endif
