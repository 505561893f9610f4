#ifndef PROSUP_CORE_TEXT_H
#define PROSUP_CORE_TEXT_H

#include <sstream>
#include <string>
#include <vector>

namespace prosup {

/// The values one after the other, as in "ssd, nmi, lncc".
template <typename Value>
std::string joined(const std::vector<Value>& values, const char* separator = ", ") {
  std::ostringstream text;
  for (std::size_t i = 0; i < values.size(); ++i)
    text << (i == 0 ? "" : separator) << values[i];
  return text.str();
}

/// The text without blanks and line ends at its ends.
inline std::string trimmed(const std::string& text) {
  constexpr const char* blanks = " \t\r\n";
  const auto first = text.find_first_not_of(blanks);
  if (first == std::string::npos)
    return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// The text with the letters of ASCII in lower case, whatever the locale.
inline std::string lower_case(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z')
      c = static_cast<char>(c - 'A' + 'a');
  return text;
}

/// A text from a file as part of a sentence: one line of at most `length` bytes.
inline std::string shown(std::string text, std::size_t length = 80) {
  for (char& c : text)
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7F')
      c = ' ';
  if (text.size() <= length)
    return text;
  while (length > 0 && (static_cast<unsigned char>(text[length]) & 0xC0u) == 0x80u)
    --length; // not within a character of UTF-8
  return text.substr(0, length) + "...";
}

inline bool ends_with(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/// `text` with a '?' for each control character, and without its middle if it is longer than any
/// message: what it quotes may come from a damaged file.
std::string one_printable_line(std::string text);

} // namespace prosup

#endif
