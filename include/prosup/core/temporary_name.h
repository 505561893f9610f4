#ifndef PROSUP_CORE_TEMPORARY_NAME_H
#define PROSUP_CORE_TEMPORARY_NAME_H

#include <filesystem>
#include <list>
#include <string>
#include <utility>

namespace prosup {

/// A file or folder that is written under another name than it will have. As long as this lives,
/// text_of(), by which all messages go, speaks of the name that the user knows.
class TemporaryName {
public:
  TemporaryName(const std::filesystem::path& temporary, const std::filesystem::path& known);
  ~TemporaryName();
  TemporaryName(const TemporaryName&) = delete;
  TemporaryName& operator=(const TemporaryName&) = delete;

private:
  std::list<std::pair<std::string, std::string>>::iterator place_;
};

/// The text with known names for temporary ones.
std::string with_known_names(std::string text);

} // namespace prosup

#endif
