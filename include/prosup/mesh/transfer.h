#ifndef PROSUP_MESH_TRANSFER_H
#define PROSUP_MESH_TRANSFER_H

#include <mpi.h>

#include "prosup/mesh/tet_mesh.h"

namespace prosup::mesh {

/// Copies a mesh from one rank to another; only these two call it.
void transfer(TetMesh& mesh, int from, int to, MPI_Comm communicator);
void transfer(UnloadedMesh& mesh, int from, int to, MPI_Comm communicator);

} // namespace prosup::mesh

#endif
