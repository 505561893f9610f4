#include "csv.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "csv_header.h"
#include "prosup/core/error.h"
#include "prosup/core/log.h"
#include "prosup/core/text.h"
#include "text_input.h"

namespace prosup::evaluation::csv {

double parse_number(const std::string& text, const std::string& where, const std::string& column) {
  // Unlike std::stod, from_chars knows no locale and no hexadecimal numbers.
  const char* first = text.data() + (text.size() > 1 && text[0] == '+' && text[1] != '-');
  const char* last = text.data() + text.size();
  double value = 0.;
  const auto [end, error] = std::from_chars(first, last, value);
  if (error != std::errc() || end != last || !std::isfinite(value))
    throw Error("In " + where + ", column '" + shown(column) + "': '" + shown(text) +
                "' is not a coordinate; write a finite number in mm with a decimal point, such as "
                "-12.5.");
  check_coordinate(value, where + ", column '" + shown(column) + "'");
  return value;
}

Table::Table(const std::string& text, std::string name) : file_(std::move(name)) {
  bool has_header = false;
  for (Record& record : records(text, file_)) {
    if (has_header)
      add_row(std::move(record));
    else if (!record.comment.empty())
      read_comment(record);
    else if (!record.names_separator()) {
      read_header(record);
      has_header = true;
    }
  }
  if (rows_.empty())
    throw Error("The file '" + file_ +
                "' has no points; write a header line and at least one line of values.");
}

void Table::read_comment(const Record& record) {
  std::string value;
  if (comment_value(record.comment, "CoordinateSystem", value))
    system_ = coordinate_system(value, evaluation::where(file_, record.line));
}

void Table::read_header(const Record& record) {
  check_header(record, file_);
  header_line_ = record.line;
  header_ = record.values;
  while (header_.back().empty())
    header_.pop_back();
  for (const std::string& text : header_) {
    const ColumnName column = column_name(text);
    names_.push_back(column.name);
    units_.push_back(column.unit);
  }
}

void Table::add_row(Record record) {
  std::vector<std::string>& values = record.values;
  while (values.size() > header_.size() && values.back().empty())
    values.pop_back();
  const bool fits = values.size() == header_.size();
  if (!fits && !record.comment.empty())
    return;
  if (!fits)
    throw Error("In " + evaluation::where(file_, record.line) + ": there are " +
                std::to_string(values.size()) + " values where the header names " +
                std::to_string(header_.size()) + " columns (" + shown(joined(header_), 200) +
                "); give one value for each, with points, not commas, in the decimals.");
  rows_.push_back(std::move(record));
}

std::optional<std::size_t> Table::find(const std::string& name) const {
  const auto found = std::find(names_.begin(), names_.end(), name);
  if (found == names_.end())
    return {};
  if (std::find(found + 1, names_.end(), name) != names_.end())
    throw Error("In " + evaluation::where(file_, header_line_) + ": the column '" + name +
                "' occurs twice; give each column its own name.");
  return static_cast<std::size_t>(found - names_.begin());
}

std::size_t Table::column(const std::string& name) const {
  const auto found = find(name);
  if (!found)
    throw Error("The file '" + file_ + "' has no column '" + name + "' (it has " +
                shown(joined(header_), 200) + "); name it in the first line.");
  return *found;
}

std::size_t Table::id_column() const {
  for (const char* name : {"id", "label", "name"})
    if (const auto found = find(name))
      return *found;
  return column("id");
}

bool Table::has(const std::array<std::string, 3>& names) const {
  return std::all_of(names.begin(), names.end(),
                     [&](const std::string& name) { return find(name).has_value(); });
}

void Table::require_mm(std::size_t column) const {
  if (units_[column].empty() || units_[column] == "mm")
    return;
  throw Error("In " + evaluation::where(file_, header_line_) + ": the column '" +
              shown(header_[column]) + "' is in '" + shown(units_[column]) +
              "', but coordinates are in mm; convert them.");
}

PointColumns Table::point_columns(const std::string& prefix, Remarks& remarks) const {
  const auto named = [&](const char* x, const char* y, const char* z) {
    return std::array<std::string, 3>{prefix + x, prefix + y, prefix + z};
  };
  const auto xyz = named("x", "y", "z"), lps = named("l", "p", "s"), ras = named("r", "a", "s");
  const int n_found = int(has(xyz)) + int(has(lps)) + int(has(ras));
  if (n_found > 1)
    throw Error("In " + evaluation::where(file_, header_line_) +
                ": the position of a point is given by several triples of columns (" +
                shown(joined(header_), 200) + "); leave only one of them.");
  const bool turned = has(ras);
  const auto& names = has(lps) ? lps : turned ? ras : xyz;
  PointColumns columns{{}, turned ? CoordinateSystem::ras : CoordinateSystem::lps};
  if (&names == &xyz)
    columns.system = system_;
  for (unsigned d = 0; d < 3; ++d) {
    columns.index[d] = column(names[d]);
    require_mm(columns.index[d]);
  }
  if (columns.system == CoordinateSystem::ras)
    remarks.add("The columns " + names[0] + ", " + names[1] + " and " + names[2] +
                " of the file '" + file_ + "' were taken as RAS and turned to LPS.");
  return columns;
}

Point<3> Table::point(std::size_t row, const PointColumns& columns) const {
  Point<3> p;
  for (unsigned d = 0; d < 3; ++d) {
    const std::size_t column = columns.index[d];
    p[d] = parse_number(text(row, column), where(row), header_[column]);
  }
  return to_lps(p, columns.system);
}

std::string Table::where(std::size_t row) const {
  return evaluation::where(file_, rows_[row].line);
}

std::string coordinates(const Point<3>& p, const std::string& what) {
  if (!std::isfinite(p[0] + p[1] + p[2]))
    throw Error("The position of " + shown(what) +
                " is not a finite number and was not written; check the registration.");
  return format("%.6f,%.6f,%.6f", p[0], p[1], p[2]);
}

std::string error_values(const ErrorBar& error, const std::string& what) {
  if (!std::isfinite(error.deviation.norm() + error.radius_95))
    throw Error("The error bar of " + shown(what) +
                " is not a finite number and was not written; check the registration.");
  return coordinates(Point<3>(error.deviation), what) + format(",%.6f", error.radius_95);
}

std::string figure_values(const MapFigures& figures, const std::string& what) {
  std::string text;
  const auto add = [&](const std::optional<double>& value) {
    if (value && !std::isfinite(*value))
      throw Error("A distance or volume at " + shown(what) +
                  " is not a finite number and was not written; check the registration.");
    text += (text.empty() ? "" : ",") + (value ? format("%.6f", *value) : "");
  };
  add(figures.volume_ratio);
  add(figures.outside);
  for (const Depth& depth : {figures.before, figures.after}) {
    add(depth.skin);
    add(depth.chest_wall);
  }
  add(figures.nipple_before);
  add(figures.nipple_after);
  return text;
}

} // namespace prosup::evaluation::csv
