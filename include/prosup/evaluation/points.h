#ifndef PROSUP_EVALUATION_POINTS_H
#define PROSUP_EVALUATION_POINTS_H

#include <deal.II/base/point.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "prosup/core/remarks.h"
#include "prosup/evaluation/error_bar.h"

namespace prosup::evaluation {

using dealii::Point;

struct NamedPoint {
  std::string id;
  Point<3> position;               ///< LPS, mm
  std::optional<ErrorBar> error{}; ///< where it is known; not read from files
};

/// The formats of lists of points.
enum class PointFormat { csv, fcsv, mrk_json };

/// The format that the ending of the file name gives, whatever the case of its letters.
/// @throws Error that lists the endings if it is none of them.
PointFormat point_format(const std::filesystem::path& file);

/// Reads points. The extension of the file name gives the format:
///  - `.csv`: a header with the columns id, x, y, z in any order, LPS mm (docs/points.md has what
///    else is understood);
///  - `.fcsv`: markups of 3D Slicer, in the coordinate system that the header
///    CoordinateSystem names (LPS, RAS, or the older 1 and 0);
///  - `.mrk.json`: markups of 3D Slicer, all control points, in the coordinateSystem of each
///    markup (default LPS). Points without a defined position are skipped.
/// In the formats of 3D Slicer the label of a point becomes its id; if the label is empty, the
/// id in the file does. What was skipped, turned or assumed goes to `remarks`.
/// @throws Error that names the file, the line or point, and what is allowed.
std::vector<NamedPoint> read_points(const std::filesystem::path& file, Remarks& remarks);
std::vector<NamedPoint> read_points(const std::filesystem::path& file);

/// Reads the `text` of a list of points that came from the file `name`.
/// @throws Error as read_points().
std::vector<NamedPoint> parse_points(const std::string& text, PointFormat format,
                                     const std::string& name, Remarks& remarks);

/// The first line of points that are written as CSV, and of those whose error bars are known.
constexpr const char* points_header = "id,x,y,z";
constexpr const char* points_with_errors_header = "id,x,y,z,sd_x,sd_y,sd_z,radius_95";

/// The format of points that are written to `file`: as point_format(), or CSV if the name has no
/// ending, such as /dev/stdout, or ends in .txt.
PointFormat output_format(const std::filesystem::path& file);

/// Writes points, LPS mm, to 1e-6 mm. If all have error bars, CSV has them in further columns, mm,
/// and markups in the descriptions of the points.
/// @throws Error if a number is not finite or the file cannot be written.
void write_points(const std::vector<NamedPoint>& points, const std::filesystem::path& file,
                  PointFormat format = PointFormat::csv);

} // namespace prosup::evaluation

#endif
