#include "prosup/evaluation/points.h"

#include "csv.h"
#include "prosup/core/error.h"
#include "prosup/core/text_file.h"
#include "slicer_markups.h"

namespace prosup::evaluation {

namespace {

bool ends_with(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

std::vector<NamedPoint> read_csv(const std::filesystem::path& file) {
  const csv::Table table(file);
  const std::size_t id = table.column("id");
  const auto position = table.point_columns("");
  std::vector<NamedPoint> points;
  for (std::size_t row = 0; row < table.n_rows(); ++row)
    points.push_back({table.text(row, id), table.point(row, position)});
  return points;
}

} // namespace

std::vector<NamedPoint> read_points(const std::filesystem::path& file) {
  const std::string name = file.filename().string();
  std::vector<NamedPoint> points;
  if (ends_with(name, ".fcsv"))
    points = read_fcsv(file);
  else if (ends_with(name, ".mrk.json"))
    points = read_mrk_json(file);
  else if (ends_with(name, ".csv"))
    points = read_csv(file);
  else
    throw Error("The format of the point file '" + file.string() +
                "' is not known; use .csv (id,x,y,z), .fcsv or .mrk.json.");
  if (points.empty())
    throw Error("The file '" + file.string() + "' has no points; give at least one.");
  return points;
}

void write_points(const std::vector<NamedPoint>& points, const std::filesystem::path& file) {
  std::string text = std::string(points_header) + "\n";
  for (const NamedPoint& point : points)
    text += csv::quoted(point.id) + "," +
            csv::coordinates(point.position, "point '" + point.id + "'") + "\n";
  write_text_file(text, file);
}

} // namespace prosup::evaluation
