#ifndef PROSUP_CORE_CSV_CELL_H
#define PROSUP_CORE_CSV_CELL_H

#include <string>

namespace prosup {

/// `text` as one value of a line of CSV: quoted where it has to be.
std::string csv_quoted(const std::string& text);

/// Words of others, such as the name of a folder, as one value of a line that is read by people:
/// as above, with an apostrophe before what a spreadsheet would take as a formula.
std::string csv_words(const std::string& words);

} // namespace prosup

#endif
