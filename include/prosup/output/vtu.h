#ifndef PROSUP_OUTPUT_VTU_H
#define PROSUP_OUTPUT_VTU_H

#include <filesystem>
#include <string>

#include "prosup/mesh/tet_mesh.h"

namespace prosup::output {

/// Writes a mesh in both its configurations for ParaView: `<name>_loaded.vtu`,
/// `<name>_unloaded.vtu`, and `<name>.pvd` that lists them as the time steps 0
/// (unloaded) and 1 (loaded). Lengths are in mm, LPS.
///
/// Point data: `displacement` u = x - X, and the position in the other
/// configuration (`unloaded` or `loaded`). Cell data: `tissue` (label),
/// `boundary` (mesh::boundary_codes()), `J` (loaded by unloaded volume) and
/// `quality` (the radius ratio of the cell in the configuration of the file, see
/// mesh::radius_ratio()).
/// @throws Error if the mesh is inconsistent, a number is not finite or a file
/// cannot be written.
void write_mesh(const mesh::UnloadedMesh& mesh, const std::filesystem::path& folder,
                const std::string& name);

/// Reads a `<name>_loaded.vtu` that write_mesh() wrote, in full precision.
/// @throws Error if the file is missing or damaged, or is not such a mesh.
mesh::UnloadedMesh read_mesh(const std::filesystem::path& loaded_vtu);

} // namespace prosup::output

#endif
