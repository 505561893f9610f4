#ifndef PROSUP_PIPELINE_PHANTOM_TRUTH_H
#define PROSUP_PIPELINE_PHANTOM_TRUTH_H

#include <array>
#include <filesystem>

#include "prosup/evaluation/target_registration_error.h"
#include "prosup/mechanics/static/quasi_static.h"
#include "prosup/pipeline/stages.h"

namespace prosup::pipeline {

/// Writes `truth.json`: how a phantom was made, and what a registration of it
/// should find. @throws Error if the file cannot be written.
void write_phantom_truth(const Stages& stages, const evaluation::ErrorStatistics& initial_error,
                         const std::array<mechanics::QuasiStaticResult, 2>& results,
                         const std::filesystem::path& file);

} // namespace prosup::pipeline

#endif
