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

} // namespace prosup::tests

#endif
