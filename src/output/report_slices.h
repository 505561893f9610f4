#ifndef PROSUP_SRC_OUTPUT_REPORT_SLICES_H
#define PROSUP_SRC_OUTPUT_REPORT_SLICES_H

#include <string>

#include "prosup/output/report.h"

namespace prosup::output {

/// Slices of the supine image in three planes, over which those of the prone image can be drawn by
/// a slider: as it was scanned, as it is carried to supine (`prone_in_supine`), and as a
/// checkerboard of both; all with the outline of the supine breast. HTML.
/// @throws Error if a mask is empty.
std::string report_slices(const ReportImages& images, const image::ScalarImage& prone_in_supine);

} // namespace prosup::output

#endif
