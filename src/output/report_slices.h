#ifndef PROSUP_SRC_OUTPUT_REPORT_SLICES_H
#define PROSUP_SRC_OUTPUT_REPORT_SLICES_H

#include <filesystem>
#include <string>

#include "prosup/output/report.h"

namespace prosup::output {

/// The prone image as it looks in supine, in the folder of a result.
constexpr const char* prone_in_supine = "prone_in_supine.nii.gz";

/// Slices of the supine image in three planes, over which those of the prone image can be drawn by
/// a slider: as it was scanned, as it is carried to supine (`prone_in_supine` of the `result`), and
/// as a checkerboard of both; all with the outlines of the supine breast, and of the prone one
/// where that is seen, carried by `supine_to_prone.nrrd` if it is there. HTML.
/// @throws Error if a mask is empty, or a file of the result is damaged.
std::string report_slices(const ReportImages& images, const std::filesystem::path& result);

} // namespace prosup::output

#endif
