#ifndef PROSUP_CORE_LOG_H
#define PROSUP_CORE_LOG_H

#include <mpi.h>

#include <string>

namespace prosup {

/// Progress messages: one permanent line per stage, and a live line that is overwritten in place on
/// a terminal and not printed elsewhere. Only rank 0 of the communicator prints, what the LogLevel
/// allows. A default-constructed Log prints nothing; it is the default for host programs.
class Log {
public:
  Log() = default;
  explicit Log(MPI_Comm communicator);

  /// Whether this rank prints anything.
  bool speaks() const { return speaks_; }

  /// Prints `text` and a newline to standard output.
  void line(const std::string& text) const;

  /// Prints "Warning: ", `sentence` and a newline to standard error.
  void warning(const std::string& sentence) const;

  /// Replaces the live line by `text`, and by how long it may still take (RemainingTime).
  void progress(const std::string& text) const;

private:
  bool speaks_ = false;
  bool on_terminal_ = false;
};

/// printf-style formatting into a string.
std::string format(const char* pattern, ...) __attribute__((format(printf, 1, 2)));

} // namespace prosup

#endif
