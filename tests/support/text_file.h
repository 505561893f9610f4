#ifndef PROSUP_TESTS_TEXT_FILE_H
#define PROSUP_TESTS_TEXT_FILE_H

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace prosup::tests {

/// Writes a file and returns its path.
inline std::filesystem::path text_file(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file) << text;
  return file;
}

inline std::string contents(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

/// The lines of standard error that are no warnings.
inline std::string without_warnings(const std::string& text) {
  std::string rest;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);)
    if (line.rfind("Warning: ", 0) != 0)
      rest += line + "\n";
  return rest;
}

} // namespace prosup::tests

#endif
