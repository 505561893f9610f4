#include <algorithm>
#include <array>

#include "csv.h"
#include "prosup/core/csv_cell.h"
#include "prosup/core/error.h"
#include "prosup/core/log.h"
#include "slicer_markups.h"
#include "text_input.h"

namespace prosup::evaluation {

namespace {

constexpr const char* usual_columns =
    "id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label,desc,associatedNodeID";

/// Takes a list apart record by record.
class FcsvReader {
public:
  explicit FcsvReader(const std::string& name) : name_(name) { read_columns(usual_columns); }

  void read(const csv::Record& record) {
    if (record.comment.empty())
      return read_point(record);
    std::string value;
    if (csv::comment_value(record.comment, "columns", value))
      read_columns(value);
    if (csv::comment_value(record.comment, "CoordinateSystem", value)) {
      const CoordinateSystem system = coordinate_system(value, where(name_, record.line));
      if (!points.empty() && system != *system_)
        throw Error("In " + where(name_, record.line) +
                    ": the coordinate system changes within the list; save the points in one.");
      system_ = system;
    }
  }

  std::vector<NamedPoint> points;

private:
  void read_columns(const std::string& names) {
    columns_ = csv::records(names, name_).empty() ? std::vector<std::string>()
                                                  : csv::records(names, name_)[0].values;
  }

  /// The value of a column, or nothing if there is none.
  std::string value(const csv::Record& record, const char* name) const {
    const auto column =
        std::size_t(std::find(columns_.begin(), columns_.end(), name) - columns_.begin());
    return column < columns_.size() && column < record.values.size() ? record.values[column] : "";
  }

  void read_point(const csv::Record& record) {
    const std::string place = where(name_, record.line);
    if (!system_)
      throw Error("The file '" + name_ +
                  "' does not name its coordinate system; add the line '# CoordinateSystem = LPS' "
                  "or '# CoordinateSystem = RAS' before the points.");
    if (record.values.size() < 4)
      throw Error("In " + place + ": there are " + std::to_string(record.values.size()) +
                  " values where a point needs at least four: id, x, y, z.");
    constexpr std::array<const char*, 3> names{"x", "y", "z"};
    Point<3> p;
    for (unsigned d = 0; d < 3; ++d)
      p[d] = csv::parse_number(value(record, names[d]), place, names[d]);
    const std::string label = value(record, "label");
    points.push_back({label.empty() ? value(record, "id") : label, to_lps(p, *system_)});
  }

  const std::string& name_;
  std::vector<std::string> columns_;
  std::optional<CoordinateSystem> system_;
};

} // namespace

std::vector<NamedPoint> parse_fcsv(const std::string& text, const std::string& name, Remarks&) {
  FcsvReader reader(name);
  for (const csv::Record& record : csv::records(text, name))
    reader.read(record);
  return std::move(reader.points);
}

std::string fcsv_text(const std::vector<NamedPoint>& points) {
  std::string text =
      std::string(
          "# Markups fiducial file version = 4.11\n# CoordinateSystem = LPS\n# columns = ") +
      usual_columns + "\n";
  for (std::size_t p = 0; p < points.size(); ++p)
    text += std::to_string(p + 1) + "," +
            csv::coordinates(points[p].position, "point '" + points[p].id + "'") +
            ",0,0,0,1,1,1,0," + csv_quoted(points[p].id) + "," + csv_quoted(described(points[p])) +
            ",\n";
  return text;
}

} // namespace prosup::evaluation
