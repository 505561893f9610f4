#include <algorithm>
#include <nlohmann/json.hpp>

#include "coordinate_system.h"
#include "json_text.h"
#include "prosup/core/error.h"
#include "prosup/core/log.h"
#include "prosup/core/text.h"
#include "slicer_markups.h"

namespace prosup::evaluation {

namespace {

using Json = nlohmann::json;

/// Whether a markup is its control points and nothing else, so that it can be mapped by them.
bool is_made_of_points(const std::string& type) {
  static const std::vector<std::string> types{"Fiducial", "Line", "Angle", "Curve", "ClosedCurve"};
  return std::find(types.begin(), types.end(), type) != types.end();
}

/// The value at `key` of `json`, or nothing.
Json value_at(const Json& json, const char* key) {
  const auto found = json.find(key);
  return found == json.end() ? Json() : *found;
}

constexpr const char* of_prosup = "prosup: "; // what follows in a description is its own

/// What somebody else has written about a point, and then `text`.
std::string appended(const std::string& description, const std::string& text) {
  std::string own = description.substr(0, description.find(of_prosup));
  while (!own.empty() && (own.back() == ' ' || own.back() == ';'))
    own.pop_back();
  return own.empty() ? text : own + "; " + text;
}

/// Moves the control points of `markup` to the positions from `next` on.
void move(Json& markup, std::vector<NamedPoint>::const_iterator& next) {
  const CoordinateSystem system =
      coordinate_system(system_name(markup).value_or("LPS"), "the markups");
  const Json original = value_at(markup, "controlPoints"), display = value_at(markup, "display");
  if (!is_made_of_points(text_at(markup, "type", "Fiducial"))) { // its frame cannot be mapped
    markup = {{"type", "Fiducial"}};
    if (!display.is_null())
      markup["display"] = display;
  }
  markup["coordinateSystem"] = system == CoordinateSystem::lps ? "LPS" : "RAS";
  markup["coordinateUnits"] = "mm";
  markup.erase("measurements");
  Json moved = Json::array();
  for (Json point : original) {
    if (text_at(point, "positionStatus", "defined") != "defined")
      continue;
    const Point<3> p = to_lps(next->position, system); // the turn is its own inverse
    point["position"] = {p[0], p[1], p[2]};
    if (const std::string text = described(*next); !text.empty())
      point["description"] = appended(text_at(point, "description", ""), text);
    moved.push_back(std::move(point));
    ++next;
  }
  markup["controlPoints"] = std::move(moved);
}

} // namespace

std::string mrk_json_like(const std::string& original, const std::string& name,
                          const std::vector<NamedPoint>& points) {
  Remarks told;
  if (parse_mrk_json(original, name, told).size() != points.size())
    throw Error("The file '" + name + "' changed while its points were mapped; map them again.");
  Json content = Json::parse(original);
  auto next = points.begin();
  for (Json& markup : content["markups"])
    move(markup, next);
  return content.dump(1) + "\n";
}

std::string described(const NamedPoint& point) {
  std::vector<std::string> parts;
  if (point.error)
    parts.push_back(described(*point.error));
  if (point.figures) {
    const MapFigures& figures = *point.figures;
    parts.push_back(format("J %.3f", figures.volume_ratio));
    if (figures.outside > 0.)
      parts.push_back(format("%.1f mm outside the mesh", figures.outside));
    const auto change = [&](const char* what, const std::optional<double>& before,
                            const std::optional<double>& after) {
      if (before && after)
        parts.push_back(format("%s %.1f mm away (before: %.1f mm)", what, *after, *before));
    };
    change("skin", figures.before.skin, figures.after.skin);
    change("chest wall", figures.before.chest_wall, figures.after.chest_wall);
    change("nipple", figures.nipple_before, figures.nipple_after);
  }
  return parts.empty() ? "" : of_prosup + joined(parts, "; ");
}

} // namespace prosup::evaluation
