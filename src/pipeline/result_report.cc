#include "result_report.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "prosup/core/log.h"
#include "shown_properties.h"

namespace prosup::pipeline {

using Json = nlohmann::json;
using output::ReportRow;

namespace {

std::string with_unit(double value, const char* unit) {
  // As people write it: 100000 Pa, not 1e+05 Pa.
  return format(std::abs(value) < 1e4 ? "%.4g %s" : "%.0f %s", value, unit);
}

std::vector<ReportRow> property_rows(const Json& material) {
  const registration::SearchRanges ranges = registration::search_ranges();
  std::vector<ReportRow> rows;
  for (const ShownProperty& property : shown_properties()) {
    const Json::json_pointer place(property.pointer);
    if (!material.contains(place))
      continue;
    const auto [low, high] = std::minmax({property.get(ranges.from), property.get(ranges.to)});
    rows.push_back(
        {property.name, with_unit(material.at(place).get<double>(), property.unit),
         "searched from " + with_unit(low, "") + "to " + with_unit(high, property.unit)});
  }
  if (const auto tilt = material.find("supine_tilt"); tilt != material.end() && tilt->size() == 2) {
    const double most = ranges.to.tilt.degrees()[0];
    rows.push_back({"Tilt of supine gravity",
                    format("%.1f degrees to the left, %.1f to the head", (*tilt)[0].get<double>(),
                           (*tilt)[1].get<double>()),
                    format("searched from %.0f to %.0f degrees", -most, most)});
  }
  return rows;
}

} // namespace

std::optional<output::ReportImages>
report_images(const PerPosition<registration::OriginalImage>& originals) {
  output::ReportImages shown;
  for (const Position position : both_positions) {
    if (originals[position].breast.values.empty())
      return {};
    shown.images[position] = &originals[position].image;
    shown.masks[position] = &originals[position].breast;
  }
  return shown;
}

void write_result_report(const std::filesystem::path& folder,
                         const std::optional<output::ReportImages>& images) {
  std::ifstream stream(folder / "summary.json");
  const Json summary = Json::parse(stream, nullptr, false);
  const Json material = summary.is_object() ? summary.value("material", Json::object()) : Json();
  output::write_report(folder, property_rows(material), images);
}

} // namespace prosup::pipeline
