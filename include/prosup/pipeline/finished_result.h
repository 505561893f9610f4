#ifndef PROSUP_PIPELINE_FINISHED_RESULT_H
#define PROSUP_PIPELINE_FINISHED_RESULT_H

#include <filesystem>
#include <string>

#include "prosup/evaluation/point_mapper.h"

namespace prosup::pipeline {

/// @throws Error if `result` is not the result folder of a finished registration.
void require_finished(const std::filesystem::path& result);

/// The map between the loaded and the unloaded configuration of `state`, prone or supine, from a
/// result folder of `register`.
/// @throws Error if the mesh is missing.
evaluation::PointMapper read_mapper(const std::filesystem::path& result, const std::string& state);

} // namespace prosup::pipeline

#endif
