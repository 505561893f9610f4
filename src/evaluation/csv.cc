#include "csv.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>

#include "prosup/core/error.h"
#include "prosup/core/log.h"
#include "prosup/core/text.h"

namespace prosup::evaluation::csv {

namespace {

std::string trimmed(const std::string& text) {
  constexpr const char* blanks = " \t\r\n";
  const auto first = text.find_first_not_of(blanks);
  if (first == std::string::npos)
    return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

} // namespace

std::string where(const std::filesystem::path& file, std::size_t line) {
  return "file '" + file.string() + "', line " + std::to_string(line);
}

std::vector<Line> read_lines(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream || std::filesystem::is_directory(file))
    throw Error("The file '" + file.string() +
                "' cannot be read; check that it exists and that you may read it.");
  std::vector<Line> lines;
  std::string text;
  for (std::size_t number = 1; std::getline(stream, text); ++number) {
    const std::string byte_order_mark = "\xEF\xBB\xBF";
    if (number == 1 && text.compare(0, 3, byte_order_mark) == 0)
      text.erase(0, 3);
    text = trimmed(text);
    if (!text.empty())
      lines.push_back({text, number});
  }
  return lines;
}

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> values(1);
  bool in_quotes = false;
  for (std::size_t c = 0; c < line.size(); ++c) {
    const bool doubled = in_quotes && line[c] == '"' && c + 1 < line.size() && line[c + 1] == '"';
    if (doubled)
      values.back() += line[c++];
    else if (line[c] == '"')
      in_quotes = !in_quotes;
    else if (line[c] == ',' && !in_quotes)
      values.emplace_back();
    else
      values.back() += line[c];
  }
  for (std::string& value : values)
    value = trimmed(value);
  return values;
}

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos)
    return text;
  std::string result = "\"";
  for (const char c : text)
    result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + "\"";
}

double parse_number(const std::string& text, const std::string& where) {
  // Unlike std::stod, from_chars knows no locale and no hexadecimal numbers.
  const char* first = text.data() + (text.size() > 1 && text[0] == '+' && text[1] != '-');
  const char* last = text.data() + text.size();
  double value = 0.;
  const auto [end, error] = std::from_chars(first, last, value);
  if (error != std::errc() || end != last || !std::isfinite(value))
    throw Error("In " + where + ": '" + text +
                "' is not a coordinate; write a finite number in mm, such as -12.5.");
  return value;
}

Table::Table(const std::filesystem::path& file) : file_(file) {
  const std::vector<Line> lines = read_lines(file);
  if (lines.size() < 2)
    throw Error("The file '" + file.string() +
                "' has no points; write a header line and at least one line of values.");
  header_ = split(lines[0].text);
  for (const std::string& name : header_)
    if (std::count(header_.begin(), header_.end(), name) > 1 && !name.empty())
      throw Error("In " + csv::where(file, lines[0].number) + ": the column '" + name +
                  "' occurs twice; give each column its own name.");
  for (std::size_t l = 1; l < lines.size(); ++l) {
    std::vector<std::string> values = split(lines[l].text);
    if (values.size() != header_.size())
      throw Error("In " + csv::where(file, lines[l].number) + ": there are " +
                  std::to_string(values.size()) + " values where the header names " +
                  std::to_string(header_.size()) + " columns (" + joined(header_) +
                  "); give one value for each.");
    rows_.push_back({std::move(values), lines[l].number});
  }
}

std::optional<std::size_t> Table::find(const std::string& name) const {
  const auto found = std::find(header_.begin(), header_.end(), name);
  if (found == header_.end())
    return {};
  return static_cast<std::size_t>(found - header_.begin());
}

std::size_t Table::column(const std::string& name) const {
  const auto found = find(name);
  if (!found)
    throw Error("The file '" + file_.string() + "' has no column '" + name + "' (it has " +
                joined(header_) + "); name it in the first line.");
  return *found;
}

std::array<std::size_t, 3> Table::point_columns(const std::string& prefix) const {
  return {column(prefix + "x"), column(prefix + "y"), column(prefix + "z")};
}

Point<3> Table::point(std::size_t row, const std::array<std::size_t, 3>& columns) const {
  Point<3> p;
  for (unsigned d = 0; d < 3; ++d)
    p[d] = parse_number(text(row, columns[d]), where(row));
  return p;
}

std::string coordinates(const Point<3>& p, const std::string& what) {
  if (!std::isfinite(p[0] + p[1] + p[2]))
    throw Error("The position of " + what +
                " is not a finite number and was not written; check the registration.");
  return format("%.6f,%.6f,%.6f", p[0], p[1], p[2]);
}

} // namespace prosup::evaluation::csv
