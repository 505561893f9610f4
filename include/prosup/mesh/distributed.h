#ifndef PROSUP_MESH_DISTRIBUTED_H
#define PROSUP_MESH_DISTRIBUTED_H

#include <deal.II/distributed/fully_distributed_tria.h>

#include <memory>

#include "prosup/mesh/tet_mesh.h"

namespace prosup::mesh {

/// Distributes a mesh over the ranks of a communicator, partitioned with METIS.
/// material_id is the tissue of a cell, boundary_id the number of its
/// BoundaryPart. cell->id().get_coarse_cell_id() is the index of the cell in
/// `mesh_on_root.cells` and vertex a of a cell is its node a there, so that
/// nodal fields find their way back. Only the mesh of rank 0 is read.
/// @throws Error on all ranks if the mesh has no cells, names a node or boundary
/// face that does not exist, or has an inverted cell.
std::unique_ptr<dealii::parallel::fullydistributed::Triangulation<3>>
make_distributed(const TetMesh& mesh_on_root, MPI_Comm communicator);

} // namespace prosup::mesh

#endif
