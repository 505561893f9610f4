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

/// Reads points; the name of the file tells its format:
///  - `.csv`: a header with the columns id, x, y, z in any order, LPS mm;
///  - `.fcsv`: 3D Slicer's markups; its CoordinateSystem header (LPS, RAS, or
///    the older 1 and 0) is honoured;
///  - `.mrk.json`: 3D Slicer's markups, all their control points; the
///    coordinateSystem of each markup (LPS if it gives none) is honoured, and
///    points without a defined position are skipped.
/// In Slicer's formats the label of a point is its id; where it is empty, its id.
/// @throws Error that names the file, the line or point, and what is allowed.
std::vector<NamedPoint> read_points(const std::filesystem::path& file);

/// Writes points as CSV: id,x,y,z; LPS mm, to 1e-6 mm.
/// @throws Error if a coordinate is not finite or the file cannot be written.
void write_points(const std::vector<NamedPoint>& points, const std::filesystem::path& file);

} // namespace prosup::evaluation

#endif
