#ifndef PROSUP_SRC_EVALUATION_CSV_HEADER_H
#define PROSUP_SRC_EVALUATION_CSV_HEADER_H

#include <string>
#include <vector>

#include "csv_records.h"

namespace prosup::evaluation::csv {

/// The name of a column without its unit, in lower case, and the unit, if there is one.
struct ColumnName {
  std::string name, unit;
};

/// Takes "Prone_X [mm]", "x(cm)" and "x_mm" apart.
ColumnName column_name(const std::string& text);

/// @throws Error that names what is wrong if `header` has another separator than the comma or is
/// no header but the first row.
void check_header(const Record& header, const std::string& file);

} // namespace prosup::evaluation::csv

#endif
