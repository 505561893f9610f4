#include <algorithm>
#include <nlohmann/json.hpp>

#include "coordinate_system.h"
#include "json_text.h"
#include "prosup/core/error.h"
#include "prosup/core/log.h"
#include "prosup/core/text.h"
#include "slicer_markups.h"
#include "text_input.h"

namespace prosup::evaluation {

namespace {

using Json = nlohmann::json;

[[noreturn]] void refuse(const std::string& name, const std::string& what) {
  throw Error("The file '" + name + "' is not a markups file of 3D Slicer: " + what +
              "; save the points again from Slicer as .mrk.json.");
}

Json parsed(const std::string& text, const std::string& name) {
  try {
    return Json::parse(text);
  } catch (const Json::parse_error& problem) {
    const std::size_t end = std::min(problem.byte, text.size());
    const auto line = 1 + std::count(text.begin(), text.begin() + std::ptrdiff_t(end), '\n');
    refuse(name, "its line " + std::to_string(line) + " is no JSON");
  } catch (const Json::exception&) {
    refuse(name, "it holds a number that is too large");
  }
}

/// One list of control points.
class Markup {
public:
  Markup(const Json& json, const std::string& name, Remarks& remarks) : json_(json), name_(name) {
    if (!json.is_object())
      refuse(name, "an entry of 'markups' is no object");
    read_system(remarks);
    read_units();
    const std::string type = text_at(json, "type", "Fiducial");
    if (type != "Fiducial" && !control_points().empty())
      remarks.add("The file '" + name + "' has a markup of type '" + shown(type) +
                  "', not only points; its control points were taken as points.");
  }

  /// Appends the points that have a position. @returns the number of those that have none.
  std::size_t append_to(std::vector<NamedPoint>& points) const {
    std::size_t n_skipped = 0;
    for (const Json& json : control_points()) {
      if (!json.is_object())
        refuse(name_, "a control point is no object");
      if (text_at(json, "positionStatus", "defined") == "defined")
        points.push_back(point(json));
      else
        ++n_skipped;
    }
    return n_skipped;
  }

private:
  void read_system(Remarks& remarks) {
    const std::optional<std::string> system = system_name(json_);
    if (!system) {
      remarks.add("The file '" + name_ +
                  "' does not name its coordinate system; its points were taken as LPS.");
      return;
    }
    system_ = coordinate_system(*system, "file '" + name_ + "'");
  }

  /// Units are one text, or one for each axis.
  void read_units() const {
    const auto units = json_.find("coordinateUnits");
    if (units == json_.end())
      return;
    const auto is_mm = [](const Json& unit) { return unit == "mm"; };
    const bool all_mm =
        units->is_array() ? std::all_of(units->begin(), units->end(), is_mm) : is_mm(*units);
    if (all_mm)
      return;
    const std::string text = units->is_string() ? units->get<std::string>() : units->dump();
    throw Error("In file '" + name_ + "': the coordinates are in '" + shown(text) +
                "'; save the markups in mm.");
  }

  const Json& control_points() const {
    static const Json none = Json::array();
    const auto found = json_.find("controlPoints");
    if (found == json_.end() || found->is_null())
      return none;
    if (!found->is_array())
      refuse(name_, "'controlPoints' is no list");
    return *found;
  }

  NamedPoint point(const Json& json) const {
    NamedPoint point;
    point.id = text_at(json, "label", "");
    if (point.id.empty())
      point.id = text_at(json, "id", "");
    const std::string where = "file '" + name_ + "', point '" + shown(point.id) + "'";
    const auto position = json.find("position");
    const auto is_number = [](const Json& value) { return value.is_number(); };
    if (position == json.end() || !position->is_array() || position->size() != 3 ||
        !std::all_of(position->begin(), position->end(), is_number))
      throw Error("In " + where +
                  ": the position does not have three coordinates; give x, y and "
                  "z in mm.");
    for (unsigned d = 0; d < 3; ++d) {
      point.position[d] = (*position)[d].get<double>();
      check_coordinate(point.position[d], where);
    }
    point.position = to_lps(point.position, system_);
    return point;
  }

  const Json& json_;
  const std::string& name_;
  CoordinateSystem system_ = CoordinateSystem::lps;
};

} // namespace

std::vector<NamedPoint> parse_mrk_json(const std::string& text, const std::string& name,
                                       Remarks& remarks) {
  const Json content = parsed(text, name);
  const auto markups = content.find("markups");
  if (markups == content.end() || !markups->is_array())
    refuse(name, "it has no list 'markups'");
  std::vector<NamedPoint> points;
  std::size_t n_skipped = 0;
  for (const Json& markup : *markups)
    n_skipped += Markup(markup, name, remarks).append_to(points);
  if (points.empty() && n_skipped > 0)
    throw Error("The file '" + name + "' has no points: none of its " + std::to_string(n_skipped) +
                " control points was placed; place them in 3D Slicer.");
  say_skipped(n_skipped, name, remarks);
  return points;
}

std::string mrk_json_text(const std::vector<NamedPoint>& points) {
  Json control_points = Json::array();
  for (std::size_t p = 0; p < points.size(); ++p) {
    control_points.push_back(
        {{"id", std::to_string(p + 1)},
         {"label", points[p].id},
         {"position", {points[p].position[0], points[p].position[1], points[p].position[2]}},
         {"positionStatus", "defined"}});
    if (const std::string text = described(points[p]); !text.empty())
      control_points.back()["description"] = text;
  }
  const Json markup{{"type", "Fiducial"},
                    {"coordinateSystem", "LPS"},
                    {"coordinateUnits", "mm"},
                    {"controlPoints", control_points}};
  const Json content{{"@schema",
                      "https://raw.githubusercontent.com/slicer/slicer/master/Modules/Loadable/"
                      "Markups/Resources/Schema/markups-schema-v1.0.3.json#"},
                     {"markups", Json::array({markup})}};
  return content.dump(1) + "\n";
}

void say_skipped(std::size_t n_skipped, const std::string& name, Remarks& remarks) {
  if (n_skipped > 0)
    remarks.add(format("In the file '%s', %zu points are named but not placed; they were left out.",
                       name.c_str(), n_skipped));
}

} // namespace prosup::evaluation
