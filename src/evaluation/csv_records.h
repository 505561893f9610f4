#ifndef PROSUP_SRC_EVALUATION_CSV_RECORDS_H
#define PROSUP_SRC_EVALUATION_CSV_RECORDS_H

#include <string>
#include <vector>

namespace prosup::evaluation::csv {

/// The values of one record of comma-separated text.
struct Record {
  std::vector<std::string> values; ///< trimmed
  std::size_t line;                ///< the one in which it starts, from 1
  std::string comment;             ///< the whole line if it starts with '#', else empty

  bool is_blank() const;
  /// Whether this is the line "sep=," by which spreadsheets announce their separator.
  bool names_separator() const;
};

/// The records of `text`. A value in double quotes may hold commas and ends of lines; a doubled
/// quote in it stands for one. Blank lines are left out.
/// @throws Error that names the file `name` if a quote is not closed or if the lines end with a
/// carriage return only.
std::vector<Record> records(const std::string& text, const std::string& name);

/// The text behind "key =" or "key:" if `comment` is "# key = text".
bool comment_value(const std::string& comment, const std::string& key, std::string& value);

} // namespace prosup::evaluation::csv

#endif
