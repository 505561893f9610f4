#include "prosup/core/csv_cell.h"

namespace prosup {

std::string csv_quoted(const std::string& text) {
  // '#' would make a comment of the line.
  if (text.find_first_of(",\"\n\r") == std::string::npos && (text.empty() || text[0] != '#'))
    return text;
  std::string result = "\"";
  for (const char c : text)
    result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + "\"";
}

std::string csv_words(const std::string& words) {
  const bool is_formula =
      !words.empty() && std::string("=+-@\t\r").find(words[0]) != std::string::npos;
  return csv_quoted((is_formula ? "'" : "") + words);
}

} // namespace prosup
