#include "text_input.h"

#include <fstream>
#include <sstream>

#include "prosup/core/error.h"

namespace prosup::evaluation {

namespace {

constexpr std::uintmax_t largest_file = 256u << 20; // bytes: millions of points

/// Length of the UTF-8 character that starts at `c`, or 0 if there is none. Overlong forms and
/// surrogates are none.
std::size_t utf8_length(const std::string& text, std::size_t c) {
  const auto byte = [&](std::size_t i) {
    return c + i < text.size() ? static_cast<unsigned char>(text[c + i]) : 0u;
  };
  const unsigned first = byte(0), second = byte(1);
  if (first < 0x80)
    return 1;
  const std::size_t length = first < 0xC2   ? 0
                             : first < 0xE0 ? 2
                             : first < 0xF0 ? 3
                             : first < 0xF5 ? 4
                                            : 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(i) & 0xC0u) != 0x80u)
      return 0;
  const bool overlong = (first == 0xE0 && second < 0xA0) || (first == 0xF0 && second < 0x90);
  const bool no_character = (first == 0xED && second > 0x9F) || (first == 0xF4 && second > 0x8F);
  return overlong || no_character ? 0 : length;
}

bool is_utf8(const std::string& text) {
  for (std::size_t c = 0; c < text.size();) {
    const std::size_t length = utf8_length(text, c);
    if (length == 0)
      return false;
    c += length;
  }
  return true;
}

std::string from_latin1(const std::string& bytes) {
  std::string text;
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80) {
      text += c;
    } else {
      text += static_cast<char>(0xC0u | (byte >> 6u));
      text += static_cast<char>(0x80u | (byte & 0x3Fu));
    }
  }
  return text;
}

} // namespace

std::string where(const std::string& name, std::size_t line) {
  return "file '" + name + "', line " + std::to_string(line);
}

std::string read_file(const std::filesystem::path& file) {
  std::error_code ignored;
  std::ifstream stream(file, std::ios::binary);
  if (!stream || std::filesystem::is_directory(file, ignored))
    throw Error("The file '" + file.string() +
                "' cannot be read; check that it exists and that you may read it.");
  if (std::filesystem::is_regular_file(file, ignored) &&
      std::filesystem::file_size(file, ignored) > largest_file)
    throw Error("The file '" + file.string() +
                "' is longer than 256 MiB, too long for a list of points; give the right file.");
  std::ostringstream content;
  content << stream.rdbuf();
  return content.str();
}

std::string as_utf8(const std::string& bytes, const std::string& name, Remarks& remarks) {
  if (bytes.compare(0, 2, "\xFF\xFE") == 0 || bytes.compare(0, 2, "\xFE\xFF") == 0)
    throw Error("The file '" + name + "' is UTF-16 text; save it as UTF-8.");
  if (bytes.find('\0') != std::string::npos)
    throw Error("The file '" + name +
                "' has bytes of value 0, so it is UTF-16 or no text; save it as UTF-8 text.");
  const std::string byte_order_mark = "\xEF\xBB\xBF";
  std::string text =
      bytes.compare(0, 3, byte_order_mark) == 0 ? bytes.substr(byte_order_mark.size()) : bytes;
  if (is_utf8(text))
    return text;
  remarks.add("The file '" + name +
              "' is not UTF-8 text; its letters were taken as Latin-1, so save it as UTF-8 if ids "
              "look wrong.");
  return from_latin1(text);
}

} // namespace prosup::evaluation
