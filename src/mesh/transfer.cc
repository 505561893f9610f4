#include "prosup/mesh/transfer.h"

#include "prosup/core/collective.h"

namespace prosup::mesh {

void transfer(TetMesh& mesh, int from, int to, MPI_Comm communicator) {
  prosup::transfer(mesh.points, from, to, communicator);
  prosup::transfer(mesh.cells, from, to, communicator);
  prosup::transfer(mesh.tissue, from, to, communicator);
  prosup::transfer(mesh.boundary_faces, from, to, communicator);
}

void transfer(UnloadedMesh& mesh, int from, int to, MPI_Comm communicator) {
  transfer(mesh.mesh, from, to, communicator);
  prosup::transfer(mesh.unloaded, from, to, communicator);
}

} // namespace prosup::mesh
