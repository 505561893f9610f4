#ifndef PROSUP_PIPELINE_RUN_OUTCOME_H
#define PROSUP_PIPELINE_RUN_OUTCOME_H

#include <filesystem>
#include <string>
#include <vector>

#include "prosup/core/child_process.h"
#include "prosup/evaluation/landmarks.h"
#include "prosup/image/voxel_image.h"
#include "prosup/output/comparison.h"

namespace prosup::pipeline {

/// What the runs of a comparison are measured by. No run sees it.
struct Yardstick {
  std::vector<evaluation::Landmark> landmarks; ///< may be empty
  image::LabelImage breast;                    ///< of the prone image
};

/// Sets error and Jacobian of a displacement field from prone to supine: the same
/// measure for every method. @throws Error if the file cannot be used.
void measure_field(const std::filesystem::path& field, const Yardstick& yardstick,
                   output::ComparisonRow& row);

/// Sets what the result folder of `prosup register` or `unload` tells.
/// @throws Error if it lacks a file.
void measure_result(const std::filesystem::path& result, bool is_registration,
                    const Yardstick& yardstick, output::ComparisonRow& row);

/// One sentence on why a program failed: what it said last, from the logs of
/// run_child().
std::string reason_of_failure(const ChildResult& child, const std::filesystem::path& log);

} // namespace prosup::pipeline

#endif
