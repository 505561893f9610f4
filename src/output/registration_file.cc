#include "prosup/output/registration_file.h"

#include <algorithm>
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

using evaluation::Covariance;

constexpr unsigned n_components = Covariance::n_independent_components;

void write_covariances(Hdf5Writer& file, const std::vector<Covariance>& covariances,
                       const std::string& name) {
  std::vector<double> components;
  for (const Covariance& covariance : covariances)
    for (unsigned i = 0; i < n_components; ++i)
      components.push_back(covariance.access_raw_entry(i));
  if (!components.empty())
    file.rows(name + "/covariance", components, n_components);
}

/// As y = rotation x + translation.
void write_alignment(Hdf5Writer& file, const image::RigidTransform& alignment) {
  const dealii::Point<3> translation = alignment(dealii::Point<3>());
  std::vector<double> rotation, shift;
  for (unsigned d = 0; d < 3; ++d) {
    shift.push_back(translation[d]);
    for (unsigned e = 0; e < 3; ++e)
      rotation.push_back(alignment.rotation[d][e]);
  }
  file.rows("alignment/rotation", rotation, 3);
  file.rows("alignment/translation", shift, 3);
}

Hdf5Reader reader_of(const std::filesystem::path& file) {
  return Hdf5Reader(file, kind, MPI_COMM_SELF,
                    "give the result folder of a registration that finished, or its "
                    "registration.h5");
}

} // namespace

void write_registration(const PerPosition<mesh::UnloadedMesh>& meshes,
                        const std::map<std::string, double>& properties,
                        const std::filesystem::path& folder,
                        const evaluation::Uncertainty::Covariances& covariances,
                        const image::RigidTransform& alignment) {
  for (const auto& [name, value] : properties)
    if (!std::isfinite(value))
      throw Error("The property '" + name +
                  "' is not a finite number; the registration was not written.");
  Hdf5Writer file(folder / registration_h5, kind, MPI_COMM_SELF);
  file.text("version", version());
  for (const auto& [name, value] : properties)
    file.number("properties/" + name, value);
  write_alignment(file, alignment);
  for (const Position position : both_positions) {
    write_breast(file, meshes[position], name_of(position));
    write_covariances(file, covariances[position], name_of(position));
  }
  file.commit();
  write_text_file(xdmf_of(meshes), folder / registration_xdmf);
}

mesh::UnloadedMesh read_registration(const std::filesystem::path& file, Position position) {
  const Hdf5Reader reader = reader_of(file);
  const std::string group = name_of(position);
  mesh::UnloadedMesh result{read_tets(reader, group),
                            points_of(reader.doubles(group + "/unloaded"))};
  check_mesh(result, group);
  return result;
}

std::optional<image::RigidTransform> read_alignment(const std::filesystem::path& file) {
  const Hdf5Reader reader = reader_of(file);
  if (reader.data_sets("alignment").size() != 2)
    return {};
  const std::vector<double> rotation = reader.doubles("alignment/rotation"),
                            shift = reader.doubles("alignment/translation");
  image::RigidTransform alignment;
  for (unsigned d = 0; d < 3; ++d) {
    alignment.translation[d] = shift.at(d);
    for (unsigned e = 0; e < 3; ++e)
      alignment.rotation[d][e] = rotation.at(3 * d + e);
  }
  return alignment;
}

std::optional<evaluation::Uncertainty::Covariances>
read_covariances(const std::filesystem::path& file) {
  const Hdf5Reader reader = reader_of(file);
  evaluation::Uncertainty::Covariances covariances;
  for (const Position position : both_positions) {
    const std::vector<std::string> names = reader.data_sets(name_of(position));
    if (std::find(names.begin(), names.end(), "covariance") == names.end())
      return {};
    const std::vector<double> components =
        reader.doubles(std::string(name_of(position)) + "/covariance");
    for (std::size_t at = 0; at + n_components <= components.size(); at += n_components) {
      Covariance& covariance = covariances[position].emplace_back();
      for (unsigned i = 0; i < n_components; ++i)
        covariance.access_raw_entry(i) = components[at + i];
    }
  }
  return covariances;
}

} // namespace prosup::output
