#ifndef PROSUP_EVALUATION_POINTS_H
#define PROSUP_EVALUATION_POINTS_H

#include <deal.II/base/point.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "prosup/core/remarks.h"
#include "prosup/evaluation/depth.h"
#include "prosup/evaluation/error_bar.h"

namespace prosup::evaluation {

using dealii::Point;

/// What a map from one state to another tells of a point besides its position.
struct MapFigures {
  double volume_ratio;   ///< J = det dx_after/dx_before of the tissue there
  double outside;        ///< distance from the mesh, mm; 0 inside
  Depth before{}, after; ///< in the state that the point comes from and in that it is mapped to
  std::optional<double> nipple_before{}, nipple_after{}; ///< distance from the nipple there, mm
};

/// A point of a list, and what is known of it.
struct NamedPoint {
  std::string id;
  Point<3> position; ///< LPS, mm
  // Where they are known; not read from files.
  std::optional<ErrorBar> error{};
  std::optional<MapFigures> figures{};
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

/// The first line of points that are written as CSV, and what is added to it if some of them have
/// error bars, and if all have figures of a map.
constexpr const char* points_header = "id,x,y,z";
constexpr const char* error_columns = ",sd_x,sd_y,sd_z,radius_95";
constexpr const char* figure_columns = ",J,outside,skin_before,chest_before,skin_after,chest_after,"
                                       "nipple_before,nipple_after";

/// All first lines that write_points() may write as CSV.
std::vector<std::string> points_headers();

/// The format of points that are written to `file`: as point_format(), or CSV if the name has no
/// ending, such as /dev/stdout, or ends in .txt.
PointFormat output_format(const std::filesystem::path& file);

/// Writes points, LPS mm, to 1e-6 mm. If some have error bars, or all have figures, CSV has them in
/// further columns, where what is not known is left empty, and markups in the descriptions of the
/// points.
/// @throws Error if a number is not finite or the file cannot be written.
void write_points(const std::vector<NamedPoint>& points, const std::filesystem::path& file,
                  PointFormat format = PointFormat::csv);

/// Writes the points that were read from the markups `original` (.mrk.json) to a file of this kind
/// with all else that is there: colours and other settings of display, names and coordinate system
/// of each list, locks and visibility. What is not kept is what belongs to the old positions:
/// measurements, points that were not placed, and the frames of planes and regions, which become
/// lists of points. @throws Error as write_points(), or as read_points() for the original.
void write_markups_like(const std::filesystem::path& original,
                        const std::vector<NamedPoint>& points, const std::filesystem::path& file);

} // namespace prosup::evaluation

#endif
