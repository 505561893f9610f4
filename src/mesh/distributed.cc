#include "prosup/mesh/distributed.h"

#include <deal.II/base/mpi.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria.h>
#include <deal.II/grid/tria_description.h>

#include <string>

#include "prosup/core/collective.h"
#include "prosup/core/error.h"

namespace prosup::mesh {

using namespace dealii;

namespace {

void check(const TetMesh& mesh) {
  const auto exists = [&](unsigned node) { return node < mesh.points.size(); };
  if (mesh.cells.empty() || mesh.tissue.size() != mesh.cells.size())
    throw Error("A mesh to be distributed needs cells, and one tissue label for each.");
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const auto& n = mesh.cells[c];
    if (!exists(n[0]) || !exists(n[1]) || !exists(n[2]) || !exists(n[3]))
      throw Error("Cell " + std::to_string(c) + " names a node that the mesh does not have.");
    if (!(tet_volume(mesh.points[n[0]], mesh.points[n[1]], mesh.points[n[2]], mesh.points[n[3]]) >
          0.))
      throw Error("Cell " + std::to_string(c) +
                  " is flat or inverted; cells must have a positive volume.");
  }
  for (const BoundaryFace& face : mesh.boundary_faces)
    for (const unsigned node : face.nodes)
      if (!exists(node))
        throw Error("A boundary face names a node that the mesh does not have.");
}

/// The mesh of rank 0, on every rank.
TetMesh broadcast(const TetMesh& mesh_on_root, MPI_Comm communicator) {
  const bool root = Utilities::MPI::this_mpi_process(communicator) == 0;
  unsigned long long sizes[3] = {mesh_on_root.points.size(), mesh_on_root.cells.size(),
                                 mesh_on_root.boundary_faces.size()};
  MPI_Bcast(sizes, 3, MPI_UNSIGNED_LONG_LONG, 0, communicator);
  const std::size_t n_points = sizes[0], n_cells = sizes[1], n_faces = sizes[2];
  std::vector<double> points(3 * n_points);
  std::vector<unsigned> cells(5 * n_cells), faces(4 * n_faces);
  if (root) {
    for (std::size_t i = 0; i < points.size(); ++i)
      points[i] = mesh_on_root.points[i / 3][i % 3];
    for (std::size_t i = 0; i < cells.size(); ++i)
      cells[i] = i % 5 < 4 ? mesh_on_root.cells[i / 5][i % 5] : mesh_on_root.tissue[i / 5];
    for (std::size_t i = 0; i < faces.size(); ++i)
      faces[i] = i % 4 < 3 ? mesh_on_root.boundary_faces[i / 4].nodes[i % 4]
                           : static_cast<unsigned>(mesh_on_root.boundary_faces[i / 4].part);
  }
  MPI_Bcast(points.data(), int(points.size()), MPI_DOUBLE, 0, communicator);
  MPI_Bcast(cells.data(), int(cells.size()), MPI_UNSIGNED, 0, communicator);
  MPI_Bcast(faces.data(), int(faces.size()), MPI_UNSIGNED, 0, communicator);
  TetMesh mesh;
  for (std::size_t i = 0; i < n_points; ++i)
    mesh.points.emplace_back(points[3 * i], points[3 * i + 1], points[3 * i + 2]);
  for (std::size_t c = 0; c < n_cells; ++c) {
    const unsigned* cell = &cells[5 * c];
    mesh.cells.push_back({cell[0], cell[1], cell[2], cell[3]});
    mesh.tissue.push_back(std::uint8_t(cell[4]));
  }
  for (std::size_t f = 0; f < n_faces; ++f) {
    const unsigned* face = &faces[4 * f];
    mesh.boundary_faces.push_back({{face[0], face[1], face[2]}, BoundaryPart(face[3])});
  }
  return mesh;
}

/// The whole mesh as a deal.II triangulation of one process.
void create_serial(const TetMesh& mesh, Triangulation<3>& triangulation) {
  std::vector<CellData<3>> cells(mesh.cells.size(), CellData<3>(4));
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    cells[c].vertices.assign(mesh.cells[c].begin(), mesh.cells[c].end());
    cells[c].material_id = mesh.tissue[c];
  }
  SubCellData boundary;
  boundary.boundary_quads.assign(mesh.boundary_faces.size(), CellData<2>(3));
  for (std::size_t f = 0; f < mesh.boundary_faces.size(); ++f) {
    const BoundaryFace& face = mesh.boundary_faces[f];
    boundary.boundary_quads[f].vertices.assign(face.nodes.begin(), face.nodes.end());
    boundary.boundary_quads[f].boundary_id = static_cast<unsigned>(face.part);
  }
  // create_triangulation() would reorder nothing for tetrahedra, so cell and
  // vertex numbers stay those of the mesh.
  triangulation.create_triangulation(mesh.points, cells, boundary);
}

} // namespace

std::unique_ptr<parallel::fullydistributed::Triangulation<3>>
make_distributed(const TetMesh& mesh_on_root, MPI_Comm communicator) {
  on_root(communicator, [&] { check(mesh_on_root); });
  const TetMesh mesh = broadcast(mesh_on_root, communicator);
  const unsigned n_ranks = Utilities::MPI::n_mpi_processes(communicator);
  Triangulation<3> serial;
  create_serial(mesh, serial);
  if (n_ranks > 1)
    GridTools::partition_triangulation(n_ranks, serial, SparsityTools::Partitioner::metis);
  const auto description =
      TriangulationDescription::Utilities::create_description_from_triangulation(serial,
                                                                                 communicator);
  auto triangulation = std::make_unique<parallel::fullydistributed::Triangulation<3>>(communicator);
  triangulation->create_triangulation(description);
  return triangulation;
}

} // namespace prosup::mesh
