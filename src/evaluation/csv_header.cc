#include "csv_header.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "prosup/core/error.h"
#include "prosup/core/text.h"
#include "text_input.h"

namespace prosup::evaluation::csv {

namespace {

constexpr std::array<const char*, 14> units{"mm",        "cm",     "m",     "um",    "\xC2\xB5m",
                                            "\xCE\xBCm", "micron", "nm",    "in",    "px",
                                            "inch",      "vox",    "voxel", "voxels"};

bool is_number(const std::string& text) {
  double value = 0.;
  const char* last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, value);
  return error == std::errc() && end == last;
}

[[noreturn]] void refuse_separator(const std::string& what, const Record& header,
                                   const std::string& file) {
  throw Error("In " + where(file, header.line) + ": the values are separated by " + what +
              "; save the table with commas between the values and points in the decimals, as in "
              "'id,x,y,z'.");
}

} // namespace

ColumnName column_name(const std::string& text) {
  const std::string lower = lower_case(trimmed(text));
  const std::size_t open = lower.find_last_of("[(");
  if (open != std::string::npos && open > 0 && (lower.back() == ']' || lower.back() == ')')) {
    std::string name = trimmed(lower.substr(0, open));
    while (name.size() > 1 && name.back() == '_')
      name.pop_back();
    return {name, trimmed(lower.substr(open + 1, lower.size() - open - 2))};
  }
  const std::size_t gap = lower.find_last_of("_ ");
  if (gap != std::string::npos && gap > 0)
    for (const std::string unit : units)
      if (lower.compare(gap + 1, std::string::npos, unit) == 0)
        return {trimmed(lower.substr(0, gap)), unit};
  return {lower, ""};
}

void check_header(const Record& header, const std::string& file) {
  const auto& values = header.values;
  const std::string& first = values[0];
  const auto has = [](const std::string& value, char separator) {
    return value.find(separator) != std::string::npos;
  };
  // In "id;x;y;z" no comma divides the names, but one may stand in a name as in "note;a, b".
  if (has(first, ';'))
    refuse_separator("semicolons", header, file);
  if (has(first, '\t') || first == "sep=")
    refuse_separator("tabs", header, file);
  if (values.size() == 1 && has(first, '|'))
    refuse_separator("vertical bars", header, file);
  if (std::count_if(values.begin(), values.end(), is_number) >= 3)
    throw Error("In " + where(file, header.line) +
                ": there are numbers where the names of the columns should be; write a header line "
                "such as 'id,x,y,z' above the points.");
}

} // namespace prosup::evaluation::csv
