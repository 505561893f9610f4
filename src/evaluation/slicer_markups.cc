#include "slicer_markups.h"

#include <fstream>
#include <nlohmann/json.hpp>

#include "csv.h"
#include "prosup/core/error.h"

namespace prosup::evaluation {

namespace {

/// Turns coordinates of the system `name` into LPS.
/// @throws Error that starts with `where` if the system is not known.
Point<3> to_lps(const Point<3>& p, const std::string& name, const std::string& where) {
  if (name == "LPS" || name == "1")
    return p;
  if (name == "RAS" || name == "0")
    return Point<3>(-p[0], -p[1], p[2]);
  throw Error("In " + where + ": the coordinate system '" + name +
              "' is not supported; save the markups in LPS or RAS.");
}

/// The text after "# key =" if the line is such a comment.
std::optional<std::string> comment_value(const std::string& line, const std::string& key) {
  const auto start = line.find(key), equals = line.find('=');
  if (line[0] != '#' || start == std::string::npos || equals == std::string::npos || start > equals)
    return {};
  const auto value = line.find_first_not_of(" \t", equals + 1);
  return value == std::string::npos ? std::string() : line.substr(value);
}

using Json = nlohmann::json;

NamedPoint control_point(const Json& json, const std::string& system, const std::string& where) {
  NamedPoint point;
  point.id = json.value("label", std::string());
  if (point.id.empty())
    point.id = json.value("id", std::string());
  const auto& position = json.at("position");
  if (!position.is_array() || position.size() != 3)
    throw Error("In " + where + ": the position of point '" + point.id +
                "' does not have three coordinates; give x, y and z in mm.");
  for (unsigned d = 0; d < 3; ++d)
    point.position[d] = position[d].get<double>();
  point.position = to_lps(point.position, system, where);
  return point;
}

void append_markup(const Json& markup, const std::string& where, std::vector<NamedPoint>& points) {
  const std::string system = markup.value("coordinateSystem", std::string("LPS"));
  const std::string units =
      markup.contains("coordinateUnits") && markup["coordinateUnits"].is_string()
          ? markup["coordinateUnits"].get<std::string>()
          : "mm";
  if (units != "mm")
    throw Error("In " + where + ": the coordinates are in '" + units +
                "'; save the markups in mm.");
  for (const Json& point : markup.at("controlPoints"))
    if (point.value("positionStatus", std::string("defined")) == "defined")
      points.push_back(control_point(point, system, where));
}

} // namespace

std::vector<NamedPoint> read_fcsv(const std::filesystem::path& file) {
  std::optional<std::string> system;
  std::vector<NamedPoint> points;
  for (const csv::Line& line : csv::read_lines(file)) {
    const std::string where = csv::where(file, line.number);
    if (const auto value = comment_value(line.text, "CoordinateSystem"))
      system = *value;
    if (line.text[0] == '#')
      continue;
    if (!system)
      throw Error("The file '" + file.string() +
                  "' does not name its coordinate system; add the line '# CoordinateSystem = LPS' "
                  "or '# CoordinateSystem = RAS' before the points.");
    // Columns: id, x, y, z, four of orientation, three flags, label, ...
    const std::vector<std::string> values = csv::split(line.text);
    if (values.size() < 4)
      throw Error("In " + where + ": there are " + std::to_string(values.size()) +
                  " values where a point needs at least four: id, x, y, z.");
    Point<3> p;
    for (unsigned d = 0; d < 3; ++d)
      p[d] = csv::parse_number(values[d + 1], where);
    constexpr std::size_t label = 11;
    const bool labelled = values.size() > label && !values[label].empty();
    points.push_back({labelled ? values[label] : values[0], to_lps(p, *system, where)});
  }
  return points;
}

std::vector<NamedPoint> read_mrk_json(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream)
    throw Error("The file '" + file.string() +
                "' cannot be read; check that it exists and that you may read it.");
  std::vector<NamedPoint> points;
  try {
    const Json content = Json::parse(stream);
    for (const Json& markup : content.at("markups"))
      append_markup(markup, "file '" + file.string() + "'", points);
  } catch (const Json::exception& problem) {
    throw Error("The file '" + file.string() + "' is not a markups file of 3D Slicer (" +
                problem.what() + "); save the points again from Slicer as .mrk.json.");
  }
  return points;
}

} // namespace prosup::evaluation
