#ifndef PROSUP_PIPELINE_FINISHED_RESULT_H
#define PROSUP_PIPELINE_FINISHED_RESULT_H

#include <filesystem>
#include <string>

#include "prosup/evaluation/point_mapper.h"

namespace prosup::pipeline {

/// @throws Error if the folder is not that of a finished registration.
void require_finished(const std::filesystem::path& result);

/// The map of a state, prone or supine, from the result folder of `register`.
/// @throws Error if it is not there.
evaluation::PointMapper read_mapper(const std::filesystem::path& result, const std::string& state);

} // namespace prosup::pipeline

#endif
