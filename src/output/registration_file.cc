#include "prosup/output/registration_file.h"

#include <cmath>

#include "mesh_checks.h"
#include "prosup/core/error.h"
#include "prosup/core/text_file.h"
#include "prosup/core/version.h"
#include "prosup/output/mesh_hdf5.h"
#include "registration_xdmf.h"

namespace prosup::output {

namespace {

constexpr const char* kind = "registration";

void write_breast(Hdf5Writer& file, const mesh::UnloadedMesh& mesh, const std::string& name) {
  check_mesh(mesh, name);
  const std::vector<double> jacobians = checked_jacobians(mesh, name);
  std::vector<double> displacement;
  for (std::size_t i = 0; i < mesh.unloaded.size(); ++i)
    for (unsigned d = 0; d < 3; ++d)
      displacement.push_back(mesh.mesh.points[i][d] - mesh.unloaded[i][d]);
  write_tets(file, name, mesh.mesh);
  file.rows(name + "/unloaded", coordinates_of(mesh.unloaded), 3);
  file.rows(name + "/displacement", displacement, 3);
  file.rows(name + "/J", jacobians);
}

} // namespace

void write_registration(const PerPosition<mesh::UnloadedMesh>& meshes,
                        const std::map<std::string, double>& properties,
                        const std::filesystem::path& folder) {
  for (const auto& [name, value] : properties)
    if (!std::isfinite(value))
      throw Error("The property '" + name +
                  "' is not a finite number; the registration was not written.");
  Hdf5Writer file(folder / registration_h5, kind, MPI_COMM_SELF);
  file.text("version", version());
  for (const auto& [name, value] : properties)
    file.number("properties/" + name, value);
  for (const Position position : both_positions)
    write_breast(file, meshes[position], name_of(position));
  file.commit();
  write_text_file(xdmf_of(meshes), folder / registration_xdmf);
}

mesh::UnloadedMesh read_registration(const std::filesystem::path& file, Position position) {
  const Hdf5Reader reader(file, kind, MPI_COMM_SELF,
                          "give the result folder of a registration that finished, or its "
                          "registration.h5");
  const std::string group = name_of(position);
  mesh::UnloadedMesh result{read_tets(reader, group),
                            points_of(reader.doubles(group + "/unloaded"))};
  check_mesh(result, group);
  return result;
}

} // namespace prosup::output
