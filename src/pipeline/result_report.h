#ifndef PROSUP_SRC_PIPELINE_RESULT_REPORT_H
#define PROSUP_SRC_PIPELINE_RESULT_REPORT_H

#include <filesystem>
#include <optional>

#include "prosup/output/report.h"
#include "prosup/registration/inputs.h"

namespace prosup::pipeline {

/// What the report shows of the images as they were read; nothing without masks.
std::optional<output::ReportImages>
report_images(const PerPosition<registration::OriginalImage>& originals);

/// Writes the report of a registration whose other files are in `folder`, with the properties of
/// its summary.json and the ranges in which they were searched.
/// @throws Error as output::write_report().
void write_result_report(const std::filesystem::path& folder,
                         const std::optional<output::ReportImages>& images);

} // namespace prosup::pipeline

#endif
