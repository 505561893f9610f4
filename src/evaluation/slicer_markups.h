#ifndef PROSUP_EVALUATION_SLICER_MARKUPS_H
#define PROSUP_EVALUATION_SLICER_MARKUPS_H

#include "prosup/evaluation/points.h"

namespace prosup::evaluation {

/// Reads 3D Slicer's `.fcsv`, the format of its versions before 5.
std::vector<NamedPoint> read_fcsv(const std::filesystem::path& file);

/// Reads 3D Slicer's `.mrk.json`.
std::vector<NamedPoint> read_mrk_json(const std::filesystem::path& file);

} // namespace prosup::evaluation

#endif
