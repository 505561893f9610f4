#ifndef PROSUP_OUTPUT_REPORT_H
#define PROSUP_OUTPUT_REPORT_H

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "prosup/core/position.h"
#include "prosup/image/voxel_image.h"

namespace prosup::output {

/// The name of the report in a result folder.
constexpr const char* report_html = "report.html";

/// The images that a registration started from, with masks that are not zero in the breast.
struct ReportImages {
  PerPosition<const image::ScalarImage*> images{};
  PerPosition<const image::LabelImage*> masks{};
};

/// One line of a table: what, its value, and a remark.
struct ReportRow {
  std::string name, value, remark{};
};

/// Writes report.html to the folder of a registration: one page without anything from elsewhere,
/// from the files that are there (summary.json, used.prm and, where they exist, landmarks.csv,
/// pictures and images in the other state). Without `images` there are no slices to compare.
/// `properties` are the mechanical properties that were found, with their ranges.
/// @throws Error if summary.json or used.prm are missing or damaged, or if it cannot be written.
void write_report(const std::filesystem::path& result, const std::vector<ReportRow>& properties,
                  const std::optional<ReportImages>& images);

} // namespace prosup::output

#endif
