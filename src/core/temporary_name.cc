#include "prosup/core/temporary_name.h"

#include <mutex>

namespace prosup {

namespace {

/// The latest first: a temporary file may lie in a temporary folder. Never destroyed, as messages
/// may still come while static objects go.
struct Names {
  std::mutex mutex;
  std::list<std::pair<std::string, std::string>> entries;
};

Names& names() {
  static auto* const all = new Names;
  return *all;
}

} // namespace

TemporaryName::TemporaryName(const std::filesystem::path& temporary,
                             const std::filesystem::path& known) {
  const std::lock_guard lock(names().mutex);
  names().entries.emplace_front(temporary.string(), known.string());
  place_ = names().entries.begin();
}

TemporaryName::~TemporaryName() {
  const std::lock_guard lock(names().mutex);
  names().entries.erase(place_);
}

std::string with_known_names(std::string text) {
  const std::lock_guard lock(names().mutex);
  for (const auto& [temporary, known] : names().entries)
    for (std::size_t at = 0; (at = text.find(temporary, at)) != std::string::npos;
         at += known.size())
      text.replace(at, temporary.size(), known);
  return text;
}

} // namespace prosup
