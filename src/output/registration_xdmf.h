#ifndef PROSUP_SRC_OUTPUT_REGISTRATION_XDMF_H
#define PROSUP_SRC_OUTPUT_REGISTRATION_XDMF_H

#include <string>

#include "prosup/core/position.h"
#include "prosup/mesh/tet_mesh.h"

namespace prosup::output {

/// The XDMF text that shows the file of write_registration().
std::string xdmf_of(const PerPosition<mesh::UnloadedMesh>& meshes);

} // namespace prosup::output

#endif
