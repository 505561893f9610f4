#include "prosup/output/mesh_hdf5.h"

#include "prosup/core/error.h"

namespace prosup::output {

using mesh::Point;

namespace {

/// @throws Error if a mesh of a file names nodes that it lacks.
void check(const mesh::TetMesh& mesh, bool is_complete, const std::string& group) {
  const auto exists = [&](unsigned node) { return node < mesh.points.size(); };
  bool is_right = is_complete && !mesh.cells.empty() && mesh.tissue.size() == mesh.cells.size();
  for (const auto& cell : mesh.cells)
    for (const unsigned node : cell)
      is_right = is_right && exists(node);
  for (const mesh::BoundaryFace& face : mesh.boundary_faces)
    for (const unsigned node : face.nodes)
      is_right = is_right && exists(node);
  if (!is_right)
    throw Error("The mesh '" + group +
                "' of an HDF5 file is not whole; its nodes, cells and tissues have to fit each "
                "other, so write it again.");
}

} // namespace

std::vector<double> coordinates_of(const std::vector<Point<3>>& points) {
  std::vector<double> coordinates;
  coordinates.reserve(3 * points.size());
  for (const Point<3>& point : points)
    for (unsigned d = 0; d < 3; ++d)
      coordinates.push_back(point[d]);
  return coordinates;
}

std::vector<Point<3>> points_of(const std::vector<double>& coordinates) {
  std::vector<Point<3>> points;
  for (std::size_t i = 0; i + 2 < coordinates.size(); i += 3)
    points.emplace_back(coordinates[i], coordinates[i + 1], coordinates[i + 2]);
  return points;
}

void write_tets(Hdf5Writer& file, const std::string& group, const mesh::TetMesh& mesh) {
  std::vector<unsigned> cells, tissue(mesh.tissue.begin(), mesh.tissue.end()), faces, parts;
  for (const auto& cell : mesh.cells)
    cells.insert(cells.end(), cell.begin(), cell.end());
  for (const mesh::BoundaryFace& face : mesh.boundary_faces) {
    faces.insert(faces.end(), face.nodes.begin(), face.nodes.end());
    parts.push_back(static_cast<unsigned>(face.part));
  }
  file.rows(group + "/points", coordinates_of(mesh.points), 3);
  file.rows(group + "/cells", cells, 4);
  file.rows(group + "/tissue", tissue);
  file.rows(group + "/boundary_faces", faces, 3);
  file.rows(group + "/boundary_parts", parts);
}

mesh::TetMesh read_tets(const Hdf5Reader& file, const std::string& group) {
  mesh::TetMesh mesh;
  mesh.points = points_of(file.doubles(group + "/points"));
  const std::vector<unsigned> cells = file.integers(group + "/cells"),
                              tissue = file.integers(group + "/tissue"),
                              faces = file.integers(group + "/boundary_faces"),
                              parts = file.integers(group + "/boundary_parts");
  for (std::size_t i = 0; i + 3 < cells.size(); i += 4)
    mesh.cells.push_back({cells[i], cells[i + 1], cells[i + 2], cells[i + 3]});
  for (const unsigned label : tissue)
    mesh.tissue.push_back(static_cast<std::uint8_t>(label));
  const bool is_complete = faces.size() == 3 * parts.size();
  for (std::size_t i = 0; is_complete && i < parts.size(); ++i)
    mesh.boundary_faces.push_back({{faces[3 * i], faces[3 * i + 1], faces[3 * i + 2]},
                                   static_cast<mesh::BoundaryPart>(parts[i])});
  check(mesh, is_complete, group);
  return mesh;
}

} // namespace prosup::output
