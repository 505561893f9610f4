#ifndef PROSUP_TESTS_TEMPORARY_FOLDER_H
#define PROSUP_TESTS_TEMPORARY_FOLDER_H

#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace prosup::tests {

/// A new empty folder, deleted with all it holds at the end of the scope.
class TemporaryFolder {
public:
  TemporaryFolder() {
    const std::string replaced(6, 'X'); // by mkdtemp
    std::string pattern =
        (std::filesystem::temp_directory_path() / "prosup-test-").string() + replaced;
    if (mkdtemp(pattern.data()) == nullptr)
      throw std::runtime_error("cannot make a temporary folder");
    path_ = pattern;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

private:
  std::filesystem::path path_;
};

} // namespace prosup::tests

#endif
