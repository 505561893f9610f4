#ifndef PROSUP_OUTPUT_REGISTRATION_FILE_H
#define PROSUP_OUTPUT_REGISTRATION_FILE_H

#include <filesystem>
#include <map>
#include <string>

#include "prosup/core/position.h"
#include "prosup/mesh/tet_mesh.h"

namespace prosup::output {

/// Names of the files of write_registration().
constexpr const char* registration_h5 = "registration.h5";
constexpr const char* registration_xdmf = "registration.xdmf";

/// Writes the result of a registration as one HDF5 file, from which points can be mapped, and an
/// XDMF file that shows it to ParaView as two time steps: 0 unloaded, 1 loaded. docs/hdf5.md
/// describes the layout. `properties` become attributes of the group `properties`. For one rank.
/// @throws Error if a mesh is inconsistent, a number is not finite or a file cannot be written.
void write_registration(const PerPosition<mesh::UnloadedMesh>& meshes,
                        const std::map<std::string, double>& properties,
                        const std::filesystem::path& folder);

/// Both configurations of one breast, in full precision. For one rank.
/// @throws Error if the file is missing or damaged, or holds no registration.
mesh::UnloadedMesh read_registration(const std::filesystem::path& file, Position position);

} // namespace prosup::output

#endif
