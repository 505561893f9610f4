#include "prosup/pipeline/finished_result.h"

#include "prosup/core/error.h"
#include "prosup/output/registration_file.h"
#include "prosup/output/vtu.h"

namespace prosup::pipeline {

namespace {

std::filesystem::path required(const std::filesystem::path& result, const std::string& name) {
  if (!std::filesystem::exists(result / name))
    throw Error("The folder '" + result.string() + "' holds no finished registration (no " + name +
                "); give the --output folder of prosup register.");
  return result / name;
}

/// Whether a result is given by its HDF5 file alone.
bool is_file(const std::filesystem::path& result) {
  return std::filesystem::is_regular_file(result);
}

std::filesystem::path h5_of(const std::filesystem::path& result) {
  return is_file(result) ? result : result / output::registration_h5;
}

} // namespace

void require_finished(const std::filesystem::path& result) {
  if (!is_file(result))
    required(result, "summary.json");
}

// The HDF5 file comes first: it holds both breasts, and a checksum that tells whether it is whole.
// Results of earlier versions have VTU files only.
mesh::UnloadedMesh read_breast(const std::filesystem::path& result, const std::string& state) {
  const std::filesystem::path h5 = h5_of(result);
  if (std::filesystem::exists(h5))
    return output::read_registration(h5, state == name_of(Position::prone) ? Position::prone
                                                                           : Position::supine);
  return output::read_mesh(required(result, state + "_loaded.vtu"));
}

evaluation::PointMapper read_mapper(const std::filesystem::path& result, const std::string& state) {
  return evaluation::PointMapper(read_breast(result, state));
}

std::optional<evaluation::Uncertainty::Covariances>
read_covariances(const std::filesystem::path& result) {
  const std::filesystem::path h5 = h5_of(result);
  if (!std::filesystem::exists(h5))
    return {};
  return output::read_covariances(h5);
}

} // namespace prosup::pipeline
