#ifndef PROSUP_BENCHMARKS_STABILITY_MAP_PICTURE_H
#define PROSUP_BENCHMARKS_STABILITY_MAP_PICTURE_H

#include <filesystem>
#include <vector>

#include "runs.h"

namespace prosup::benchmarks {

/// Draws a panel for each correction, prone above supine: softness over damping,
/// with the outcome and the number of steps in each field.
void write_picture(const std::vector<Run>& runs, const std::filesystem::path& file);

} // namespace prosup::benchmarks

#endif
