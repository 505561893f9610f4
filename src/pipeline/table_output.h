#ifndef PROSUP_SRC_PIPELINE_TABLE_OUTPUT_H
#define PROSUP_SRC_PIPELINE_TABLE_OUTPUT_H

#include <filesystem>

namespace prosup::pipeline {

/// @throws Error if the name of an output file promises another format than CSV.
void require_csv(const std::filesystem::path& output);

} // namespace prosup::pipeline

#endif
