#include "prosup/core/log.h"

#include <fcntl.h>
#include <unistd.h>

#include <chrono>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>

#include "prosup/core/log_file.h"
#include "prosup/core/log_level.h"
#include "prosup/core/remaining_time.h"

namespace prosup {

namespace {

constexpr const char* erase_line = "\r\033[K";

/// mpirun gives its processes a terminal of their own, wherever its output
/// goes; then it is mpirun's standard output that tells.
bool someone_watches() {
  if (isatty(STDOUT_FILENO) == 0)
    return false;
  if (std::getenv("OMPI_COMM_WORLD_SIZE") == nullptr)
    return true;
  const std::string launcher = format("/proc/%d/fd/1", static_cast<int>(getppid()));
  const int descriptor = open(launcher.c_str(), O_WRONLY | O_NOCTTY);
  const bool is_terminal = descriptor >= 0 && isatty(descriptor) != 0;
  if (descriptor >= 0)
    close(descriptor);
  return is_terminal;
}

} // namespace

Log::Log(MPI_Comm communicator) {
  int rank = 0;
  MPI_Comm_rank(communicator, &rank);
  speaks_ = rank == 0;
  on_terminal_ = speaks_ && someone_watches();
}

void Log::line(const std::string& text) const {
  if (!speaks_)
    return;
  LogFile::add(text);
  if (log_level() < LogLevel::info)
    return;
  std::printf("%s%s\n", on_terminal_ ? erase_line : "", text.c_str());
  std::fflush(stdout);
}

void Log::warning(const std::string& sentence) const {
  if (!speaks_)
    return;
  LogFile::add("Warning: " + sentence);
  if (log_level() < LogLevel::warning)
    return;
  std::fprintf(stderr, "%sWarning: %s\n", on_terminal_ ? erase_line : "", sentence.c_str());
}

void Log::progress(const std::string& text) const {
  // What changes faster than it can be read only costs time.
  constexpr std::chrono::milliseconds shortest_interval(200);
  static std::chrono::steady_clock::time_point last;
  const auto now = std::chrono::steady_clock::now();
  if (speaks_ && log_level() == LogLevel::debug)
    return line(text);
  if (!on_terminal_ || log_level() < LogLevel::info || now - last < shortest_interval)
    return;
  last = now;
  std::printf("%s%s%s", erase_line, text.c_str(), RemainingTime::in_words().c_str());
  std::fflush(stdout);
}

std::string format(const char* pattern, ...) {
  va_list arguments, again;
  va_start(arguments, pattern);
  va_copy(again, arguments);
  const int length = std::vsnprintf(nullptr, 0, pattern, arguments);
  va_end(arguments);
  std::string text(static_cast<std::size_t>(length), '\0');
  std::vsnprintf(text.data(), text.size() + 1, pattern, again);
  va_end(again);
  return text;
}

} // namespace prosup
