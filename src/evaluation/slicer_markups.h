#ifndef PROSUP_EVALUATION_SLICER_MARKUPS_H
#define PROSUP_EVALUATION_SLICER_MARKUPS_H

#include "prosup/evaluation/points.h"

namespace prosup::evaluation {

/// Reads the text of 3D Slicer's `.fcsv`, the format of its versions before 5.
std::vector<NamedPoint> parse_fcsv(const std::string& text, const std::string& name,
                                   Remarks& remarks);

/// Reads the text of 3D Slicer's `.mrk.json`.
std::vector<NamedPoint> parse_mrk_json(const std::string& text, const std::string& name,
                                       Remarks& remarks);

/// Points as text of these formats, in LPS, mm.
std::string fcsv_text(const std::vector<NamedPoint>& points);
std::string mrk_json_text(const std::vector<NamedPoint>& points);

/// The text of an .mrk.json file from which `points` were read, with their new positions.
std::string mrk_json_like(const std::string& original, const std::string& name,
                          const std::vector<NamedPoint>& points);

/// What is known of a point besides its position, in words; may be empty.
std::string described(const NamedPoint& point);

/// Says that `n_skipped` points of the file `name` have no position, if there are any.
void say_skipped(std::size_t n_skipped, const std::string& name, Remarks& remarks);

} // namespace prosup::evaluation

#endif
