#include "prosup/mesh/boundary_codes.h"

#include <algorithm>
#include <map>

#include "boundary_faces.h"

namespace prosup::mesh {

namespace {

std::array<unsigned, 3> sorted(std::array<unsigned, 3> nodes) {
  std::sort(nodes.begin(), nodes.end());
  return nodes;
}

} // namespace

std::vector<std::uint8_t> boundary_codes(const TetMesh& mesh) {
  std::map<std::array<unsigned, 3>, BoundaryPart> parts;
  for (const BoundaryFace& face : mesh.boundary_faces)
    parts[sorted(face.nodes)] = face.part;
  std::vector<std::uint8_t> codes(mesh.cells.size(), 0);
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    for (unsigned f = 0; f < 4; ++f) {
      const auto part = parts.find(sorted(face_nodes(mesh.cells[c], f)));
      if (part != parts.end())
        codes[c] = static_cast<std::uint8_t>(codes[c] | unsigned(part->second) << 2 * f);
    }
  return codes;
}

std::vector<BoundaryFace> boundary_faces(const TetMesh& mesh,
                                         const std::vector<std::uint8_t>& codes) {
  std::vector<BoundaryFace> faces;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    for (unsigned f = 0; f < 4; ++f)
      if (const unsigned part = codes[c] >> 2 * f & 3u)
        faces.push_back({face_nodes(mesh.cells[c], f), BoundaryPart(part)});
  return faces;
}

} // namespace prosup::mesh
