#ifndef PROSUP_MESH_VOLUME_MESHER_H
#define PROSUP_MESH_VOLUME_MESHER_H

#include "triangle_mesh.h"

namespace prosup::mesh {

/// Fills a closed surface with tetrahedra of about `edge_length` (gmsh), and
/// optimises them. The nodes of the surface keep their numbers and positions.
/// Only points and cells of the result are filled in; without cells if gmsh fails,
/// as it does where the surface cuts itself.
TetMesh fill_with_tets(const TriangleMesh& surface, double edge_length);

} // namespace prosup::mesh

#endif
