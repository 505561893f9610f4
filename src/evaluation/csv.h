#ifndef PROSUP_EVALUATION_CSV_H
#define PROSUP_EVALUATION_CSV_H

#include <deal.II/base/point.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "coordinate_system.h"
#include "csv_records.h"
#include "prosup/core/remarks.h"
#include "prosup/evaluation/error_bar.h"
#include "prosup/evaluation/points.h"

namespace prosup::evaluation::csv {

using dealii::Point;

/// One finite number with a decimal point, mm.
/// @throws Error that starts with "In `where`" and names the column.
double parse_number(const std::string& text, const std::string& where, const std::string& column);

/// The columns of a point and what they mean.
struct PointColumns {
  std::array<std::size_t, 3> index;
  CoordinateSystem system;
};

/// A table whose columns are found by name, whatever the case of its letters. A unit behind a name
/// is no part of it: `x_mm`, `x [mm]` and `x (mm)` are `x`.
class Table {
public:
  /// Reads the header and checks that all rows have as many values. Empty columns on the right,
  /// blank lines and comments (`# ...`) are left out.
  /// @throws Error that names the file `name` if there are no rows or the separators are not
  /// commas.
  Table(const std::string& text, std::string name);

  std::size_t n_rows() const { return rows_.size(); }

  /// Number of the column with this name, if there is one. @throws Error if there are several.
  std::optional<std::size_t> find(const std::string& name) const;

  /// @throws Error that lists the columns there are.
  std::size_t column(const std::string& name) const;

  /// The column `id`, or else `label` or `name`.
  std::size_t id_column() const;

  /// The columns prefix + "x", "y", "z", or "l", "p", "s", or "r", "a", "s", which is said.
  /// @throws Error if they are missing, ambiguous or not in mm.
  PointColumns point_columns(const std::string& prefix, Remarks& remarks) const;

  const std::string& text(std::size_t row, std::size_t column) const {
    return rows_[row].values[column];
  }
  /// LPS, mm.
  Point<3> point(std::size_t row, const PointColumns& columns) const;

  std::string where(std::size_t row) const;

private:
  void read_comment(const Record& record);
  void read_header(const Record& record);
  void add_row(Record record);
  bool has(const std::array<std::string, 3>& names) const;
  void require_mm(std::size_t column) const;

  std::string file_;
  std::size_t header_line_ = 0;
  std::vector<std::string> header_; ///< as it is written
  std::vector<std::string> names_;  ///< without units, in lower case
  std::vector<std::string> units_;
  std::vector<Record> rows_;
  CoordinateSystem system_ = CoordinateSystem::lps; ///< of x, y, z
};

/// "x,y,z" to 1e-6 mm. @throws Error that names `what` if a coordinate is not finite.
std::string coordinates(const Point<3>& p, const std::string& what);

/// "sd_x,sd_y,sd_z,radius_95" to 1e-6 mm. @throws Error that names `what` if one is not finite.
std::string error_values(const ErrorBar& error, const std::string& what);

/// The values of figure_columns to 1e-6. @throws as above.
std::string figure_values(const MapFigures& figures, const std::string& what);

} // namespace prosup::evaluation::csv

#endif
