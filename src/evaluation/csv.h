#ifndef PROSUP_EVALUATION_CSV_H
#define PROSUP_EVALUATION_CSV_H

#include <deal.II/base/point.h>

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace prosup::evaluation::csv {

using dealii::Point;

/// One line of a text file, its end trimmed, and its number from 1.
struct Line {
  std::string text;
  std::size_t number;
};

/// The lines that are not blank. @throws Error if the file cannot be read.
std::vector<Line> read_lines(const std::filesystem::path& file);

/// The values of a comma-separated line, trimmed. A value in double quotes may
/// hold commas; a doubled quote stands for one.
std::vector<std::string> split(const std::string& line);

/// `text` as one value of a line: quoted where it has to be.
std::string quoted(const std::string& text);

/// "file 'name', line 3": where a mistake is.
std::string where(const std::filesystem::path& file, std::size_t line);

/// @throws Error, that starts with `where`, if `text` is not one finite number.
double parse_number(const std::string& text, const std::string& where);

/// A table whose columns are found by name.
class Table {
public:
  /// Reads the header and checks that all rows have as many values.
  /// @throws Error if the file cannot be read, has no rows, or a name occurs twice.
  explicit Table(const std::filesystem::path& file);

  std::size_t n_rows() const { return rows_.size(); }

  /// Number of the column with this name, if there is one.
  std::optional<std::size_t> find(const std::string& name) const;

  /// @throws Error that lists the columns there are.
  std::size_t column(const std::string& name) const;

  /// Numbers of the columns prefix + "x", "y", "z".
  std::array<std::size_t, 3> point_columns(const std::string& prefix) const;

  const std::string& text(std::size_t row, std::size_t column) const {
    return rows_[row].values[column];
  }
  Point<3> point(std::size_t row, const std::array<std::size_t, 3>& columns) const;

  std::string where(std::size_t row) const { return csv::where(file_, rows_[row].line); }

private:
  struct Row {
    std::vector<std::string> values;
    std::size_t line;
  };
  std::filesystem::path file_;
  std::vector<std::string> header_;
  std::vector<Row> rows_;
};

/// "x,y,z" to 1e-6 mm. @throws Error that names `what` if a coordinate is not finite.
std::string coordinates(const Point<3>& p, const std::string& what);

} // namespace prosup::evaluation::csv

#endif
