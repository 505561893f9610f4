#ifndef PROSUP_OUTPUT_REGISTRATION_FILE_H
#define PROSUP_OUTPUT_REGISTRATION_FILE_H

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "prosup/core/position.h"
#include "prosup/evaluation/error_bar.h"
#include "prosup/image/rigid_transform.h"
#include "prosup/mesh/tet_mesh.h"

namespace prosup::output {

/// Names of the files of write_registration().
constexpr const char* registration_h5 = "registration.h5";
constexpr const char* registration_xdmf = "registration.xdmf";

/// Writes the result of a registration as one HDF5 file, from which points can be mapped, and an
/// XDMF file that shows it to ParaView as two time steps: 0 unloaded, 1 loaded. docs/hdf5.md
/// describes the layout. `properties` become attributes of the group `properties`; the covariances
/// are left out if they are empty; `alignment` takes the supine chest to the prone one. For one
/// rank.
/// @throws Error if a mesh is inconsistent, a number is not finite or a file cannot be written.
void write_registration(const PerPosition<mesh::UnloadedMesh>& meshes,
                        const std::map<std::string, double>& properties,
                        const std::filesystem::path& folder,
                        const evaluation::Uncertainty::Covariances& covariances = {},
                        const image::RigidTransform& alignment = {});

/// Both configurations of one breast, in full precision. For one rank.
/// @throws Error if the file is missing or damaged, or holds no registration.
mesh::UnloadedMesh read_registration(const std::filesystem::path& file, Position position);

/// The rigid motion from supine coordinates to those of the prone image and the unloaded state, if
/// the file has it. @throws as above.
std::optional<image::RigidTransform> read_alignment(const std::filesystem::path& file);

/// The covariances at the nodes of both meshes, if the file has them. @throws as above.
std::optional<evaluation::Uncertainty::Covariances>
read_covariances(const std::filesystem::path& file);

} // namespace prosup::output

#endif
