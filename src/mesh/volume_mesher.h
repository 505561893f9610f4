#ifndef PROSUP_MESH_VOLUME_MESHER_H
#define PROSUP_MESH_VOLUME_MESHER_H

#include "triangle_mesh.h"

namespace prosup::mesh {

/// Fills a closed surface with tetrahedra of about `edge_length` (gmsh), and
/// optimises them. The nodes of the surface keep their numbers and positions.
/// Only points and cells of the result are filled in.
/// @throws Error if gmsh cannot fill the surface.
TetMesh fill_with_tets(const TriangleMesh& surface, double edge_length);

} // namespace prosup::mesh

#endif
