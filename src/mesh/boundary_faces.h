#ifndef PROSUP_MESH_BOUNDARY_FACES_H
#define PROSUP_MESH_BOUNDARY_FACES_H

#include <array>
#include <vector>

#include "prosup/mesh/tet_mesh.h"

namespace prosup::mesh {

/// Face of a positively oriented cell opposite to corner `a`, seen from outside.
inline std::array<unsigned, 3> face_nodes(const std::array<unsigned, 4>& cell, unsigned a) {
  constexpr unsigned corners[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
  return {cell[corners[a][0]], cell[corners[a][1]], cell[corners[a][2]]};
}

/// A face that only one cell has, corners in order so that the normal points outwards.
struct OuterFace {
  std::array<unsigned, 3> nodes;
  unsigned cell;
};

std::vector<OuterFace> outer_faces(const TetMesh& mesh);

} // namespace prosup::mesh

#endif
