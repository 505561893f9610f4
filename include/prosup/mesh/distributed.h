#ifndef PROSUP_MESH_DISTRIBUTED_H
#define PROSUP_MESH_DISTRIBUTED_H

#include <deal.II/distributed/fully_distributed_tria.h>

#include <memory>

#include "prosup/mesh/tet_mesh.h"

namespace prosup::mesh {

/// Distributes the mesh of rank 0 over the ranks of a communicator, partitioned with METIS.
/// The material_id of a cell is its tissue, the boundary_id of a face the number of its
/// BoundaryPart. cell->id().get_coarse_cell_id() is the index of the cell in
/// `mesh_on_root.cells`, and vertex a of the cell is node a there, so that nodal fields can be
/// mapped back.
/// @throws Error on all ranks if the mesh has no cells, refers to a node or boundary face that
/// does not exist, or has an inverted cell.
std::unique_ptr<dealii::parallel::fullydistributed::Triangulation<3>>
make_distributed(const TetMesh& mesh_on_root, MPI_Comm communicator);

} // namespace prosup::mesh

#endif
