#include "prosup/evaluation/points.h"

#include <algorithm>
#include <set>

#include "csv.h"
#include "prosup/core/csv_cell.h"
#include "prosup/core/error.h"
#include "prosup/core/log.h"
#include "prosup/core/text.h"
#include "prosup/core/text_file.h"
#include "slicer_markups.h"
#include "text_input.h"

namespace prosup::evaluation {

namespace {

/// Tables of 3D Slicer mark points that were named but not placed by 0.
bool is_placed(const csv::Table& table, std::size_t row) {
  const auto column = table.find("defined");
  if (!column)
    return true;
  const std::string value = lower_case(table.text(row, *column));
  return value != "0" && value != "false";
}

std::vector<NamedPoint> parse_csv(const std::string& text, const std::string& name,
                                  Remarks& remarks) {
  const csv::Table table(text, name);
  const std::size_t id = table.id_column();
  const csv::PointColumns position = table.point_columns("", remarks);
  std::vector<NamedPoint> points;
  for (std::size_t row = 0; row < table.n_rows(); ++row)
    if (is_placed(table, row))
      points.push_back({table.text(row, id), table.point(row, position)});
  say_skipped(table.n_rows() - points.size(), name, remarks);
  return points;
}

template <typename Value>
bool all_have(const std::vector<NamedPoint>& points, std::optional<Value> NamedPoint::*value) {
  return !points.empty() && std::all_of(points.begin(), points.end(), [&](const NamedPoint& p) {
    return (p.*value).has_value();
  });
}

std::string csv_text(const std::vector<NamedPoint>& points) {
  const bool has_errors = std::any_of(points.begin(), points.end(),
                                      [](const NamedPoint&p) { return p.error.has_value(); }),
             has_figures = all_have(points, &NamedPoint::figures);
  std::string text = std::string(points_header) + (has_errors ? error_columns : "") +
                     (has_figures ? figure_columns : "") + "\n";
  for (const NamedPoint& point : points) {
    const std::string what = "point '" + point.id + "'";
    text += csv_quoted(point.id) + "," + csv::coordinates(point.position, what) +
            (point.error  ? "," + csv::error_values(*point.error, what)
             : has_errors ? ",,,,"
                          : "") +
            (has_figures ? "," + csv::figure_values(*point.figures, what) : "") + "\n";
  }
  return text;
}

void say_repeated_ids(const std::vector<NamedPoint>& points, const std::string& name,
                      Remarks& remarks) {
  std::set<std::string> seen;
  std::size_t n_repeated = 0;
  std::string first;
  for (const NamedPoint& point : points)
    if (!seen.insert(point.id).second && ++n_repeated == 1)
      first = point.id;
  if (n_repeated > 0)
    remarks.add(format("In the file '%s', %zu of %zu points have the id of another one, such as "
                       "'%s'; all are used, in their order.",
                       name.c_str(), n_repeated, points.size(), shown(first).c_str()));
}

} // namespace

PointFormat point_format(const std::filesystem::path& file) {
  const std::string name = lower_case(file.filename().string());
  if (ends_with(name, ".fcsv"))
    return PointFormat::fcsv;
  if (ends_with(name, ".mrk.json"))
    return PointFormat::mrk_json;
  if (ends_with(name, ".csv"))
    return PointFormat::csv;
  throw Error("The format of the point file '" + file.string() +
              "' is not known; use .csv (id,x,y,z), .fcsv or .mrk.json.");
}

std::vector<NamedPoint> parse_points(const std::string& text, PointFormat format,
                                     const std::string& name, Remarks& remarks) {
  const std::string utf8 = as_utf8(text, name, remarks);
  std::vector<NamedPoint> points = format == PointFormat::csv ? parse_csv(utf8, name, remarks)
                                   : format == PointFormat::fcsv
                                       ? parse_fcsv(utf8, name, remarks)
                                       : parse_mrk_json(utf8, name, remarks);
  if (points.empty())
    throw Error("The file '" + name + "' has no points; give at least one.");
  say_repeated_ids(points, name, remarks);
  return points;
}

std::vector<NamedPoint> read_points(const std::filesystem::path& file, Remarks& remarks) {
  const PointFormat format = point_format(file);
  return parse_points(read_file(file), format, file.string(), remarks);
}

std::vector<NamedPoint> read_points(const std::filesystem::path& file) {
  Remarks untold;
  return read_points(file, untold);
}

PointFormat output_format(const std::filesystem::path& file) {
  const std::string ending = lower_case(file.extension().string());
  return ending.empty() || ending == ".txt" ? PointFormat::csv : point_format(file);
}

std::vector<std::string> points_headers() {
  const std::string plain = points_header, with_errors = plain + error_columns;
  return {plain, with_errors, plain + figure_columns, with_errors + figure_columns};
}

void write_markups_like(const std::filesystem::path& original,
                        const std::vector<NamedPoint>& points, const std::filesystem::path& file) {
  csv_text(points); // checks that all are finite
  const std::string name = original.string();
  Remarks told; // when they were read
  write_text_file(mrk_json_like(as_utf8(read_file(original), name, told), name, points), file);
}

void write_points(const std::vector<NamedPoint>& points, const std::filesystem::path& file,
                  PointFormat format) {
  const std::string table = csv_text(points); // checks that all are finite
  write_text_file(format == PointFormat::csv    ? table
                  : format == PointFormat::fcsv ? fcsv_text(points)
                                                : mrk_json_text(points),
                  file);
}

} // namespace prosup::evaluation
