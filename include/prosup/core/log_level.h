#ifndef PROSUP_CORE_LOG_LEVEL_H
#define PROSUP_CORE_LOG_LEVEL_H

#include <string>
#include <vector>

namespace prosup {

/// What all Logs of this process show; each level shows more than the one before.
enum class LogLevel {
  error,   ///< nothing: errors are exceptions, and the program tells them
  warning, ///< warnings
  info,    ///< lines, and the live line; the default
  debug    ///< every step of the progress, as a line
};

/// Names of the levels, in the order of the enumerators.
const std::vector<std::string>& log_level_names();

/// The present one.
LogLevel log_level();
/// From now on. A LogFile gets lines and warnings all the same, and what `debug` shows only at that
/// level.
void set_log_level(LogLevel level);

} // namespace prosup

#endif
