#include "boundary_faces.h"

#include <algorithm>

namespace prosup::mesh {

std::vector<OuterFace> outer_faces(const TetMesh& mesh) {
  struct SortedFace {
    std::array<unsigned, 3> sorted;
    OuterFace face;
    bool operator<(const SortedFace& other) const { return sorted < other.sorted; }
  };
  std::vector<SortedFace> faces;
  faces.reserve(4 * mesh.cells.size());
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    for (unsigned a = 0; a < 4; ++a) {
      const OuterFace face{face_nodes(mesh.cells[c], a), unsigned(c)};
      auto sorted = face.nodes;
      std::sort(sorted.begin(), sorted.end());
      faces.push_back({sorted, face});
    }
  std::sort(faces.begin(), faces.end());
  std::vector<OuterFace> result;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const bool as_before = f > 0 && faces[f - 1].sorted == faces[f].sorted;
    const bool as_next = f + 1 < faces.size() && faces[f + 1].sorted == faces[f].sorted;
    if (!as_before && !as_next)
      result.push_back(faces[f].face);
  }
  return result;
}

} // namespace prosup::mesh
