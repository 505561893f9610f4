#ifndef PROSUP_SRC_PIPELINE_RUN_FILES_H
#define PROSUP_SRC_PIPELINE_RUN_FILES_H

#include <deal.II/base/parameter_handler.h>

#include <filesystem>
#include <string>
#include <vector>

#include "prosup/pipeline/all_parameters.h"

namespace prosup::pipeline {

/// The log in a result folder.
constexpr const char* log_txt = "log.txt";

/// What a command reads as far as its parameters name it, and the parameter file itself.
std::vector<std::filesystem::path> files_read(const AllParameters& parameters,
                                              const std::filesystem::path& parameter_file);

/// The files that a command may write to its result folder with these parameters, as ResultFolder
/// takes them. A command that writes another file has to name it here, so that a run can tell
/// before it computes what stands in its way.
std::vector<std::string> files_written(const std::string& command,
                                       const dealii::ParameterHandler& parameters);

} // namespace prosup::pipeline

#endif
