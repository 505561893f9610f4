#ifndef PROSUP_PIPELINE_FINISHED_RESULT_H
#define PROSUP_PIPELINE_FINISHED_RESULT_H

#include <filesystem>
#include <optional>
#include <string>

#include "prosup/evaluation/error_bar.h"
#include "prosup/evaluation/point_mapper.h"

namespace prosup::pipeline {

/// @throws Error if `result` is neither the result folder of a finished registration nor a file,
/// which has to be a registration.h5.
void require_finished(const std::filesystem::path& result);

/// The mesh of `state`, prone or supine, from a result folder of `register` or its
/// registration.h5. @throws Error if it is missing or damaged.
mesh::UnloadedMesh read_breast(const std::filesystem::path& result, const std::string& state);

/// The map between the loaded and the unloaded configuration of `state`, prone or supine, from a
/// result folder of `register` or its registration.h5.
/// @throws Error if the mesh is missing or damaged.
evaluation::PointMapper read_mapper(const std::filesystem::path& result, const std::string& state);

/// The covariances of a result, if it has them: results of earlier versions and of finite
/// differences have none. @throws Error if they are damaged.
std::optional<evaluation::Uncertainty::Covariances>
read_covariances(const std::filesystem::path& result);

} // namespace prosup::pipeline

#endif
