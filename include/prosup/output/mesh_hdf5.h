#ifndef PROSUP_OUTPUT_MESH_HDF5_H
#define PROSUP_OUTPUT_MESH_HDF5_H

#include <string>
#include <vector>

#include "prosup/mesh/tet_mesh.h"
#include "prosup/output/hdf5_file.h"

namespace prosup::output {

/// Writes a mesh, which one rank has and whose other ranks have none, to a group: `points` (loaded
/// positions, LPS mm), `cells` (four nodes each), `tissue` (label of each cell), `boundary_faces`
/// (three nodes each) and `boundary_parts` (mesh::BoundaryPart). Collective.
void write_tets(Hdf5Writer& file, const std::string& group, const mesh::TetMesh& mesh);

/// Reads it again, on every rank. Collective.
/// @throws Error if the parts do not fit each other.
mesh::TetMesh read_tets(const Hdf5Reader& file, const std::string& group);

/// Points as rows of three numbers, and back.
std::vector<double> coordinates_of(const std::vector<mesh::Point<3>>& points);
std::vector<mesh::Point<3>> points_of(const std::vector<double>& coordinates);

} // namespace prosup::output

#endif
