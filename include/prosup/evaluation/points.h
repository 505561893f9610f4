#ifndef PROSUP_EVALUATION_POINTS_H
#define PROSUP_EVALUATION_POINTS_H

#include <deal.II/base/point.h>

#include <filesystem>
#include <string>
#include <vector>

namespace prosup::evaluation {

using dealii::Point;

struct NamedPoint {
  std::string id;
  Point<3> position; ///< LPS, mm
};

/// Reads points. The extension of the file name gives the format:
///  - `.csv`: a header with the columns id, x, y, z in any order, LPS mm;
///  - `.fcsv`: markups of 3D Slicer, in the coordinate system that the header
///    CoordinateSystem names (LPS, RAS, or the older 1 and 0);
///  - `.mrk.json`: markups of 3D Slicer, all control points, in the coordinateSystem of each
///    markup (default LPS). Points without a defined position are skipped.
/// In the formats of 3D Slicer the label of a point becomes its id; if the label is empty, the
/// id in the file does.
/// @throws Error that names the file, the line or point, and what is allowed.
std::vector<NamedPoint> read_points(const std::filesystem::path& file);

/// The first line of what write_points() writes.
constexpr const char* points_header = "id,x,y,z";

/// Writes points as CSV with the columns id, x, y, z; LPS mm, to 1e-6 mm.
/// @throws Error if a coordinate is not finite or the file cannot be written.
void write_points(const std::vector<NamedPoint>& points, const std::filesystem::path& file);

} // namespace prosup::evaluation

#endif
