#include "prosup/core/log_level.h"

namespace prosup {

namespace {

// Logs are copied to all parts of a run, and those of other ranks come from elsewhere; what they
// share is the process, as they do its terminal.
LogLevel shown = LogLevel::info;

} // namespace

const std::vector<std::string>& log_level_names() {
  static const std::vector<std::string> names{"error", "warning", "info", "debug"};
  return names;
}

LogLevel log_level() {
  return shown;
}

void set_log_level(LogLevel level) {
  shown = level;
}

} // namespace prosup
