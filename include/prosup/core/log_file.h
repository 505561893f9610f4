#ifndef PROSUP_CORE_LOG_FILE_H
#define PROSUP_CORE_LOG_FILE_H

#include <filesystem>
#include <string>

namespace prosup {

/// A file that all Logs of this process write to as well, as long as it is open: their lines and
/// warnings with date and time, in local time. Several ranks may have the same file. One at a time.
class LogFile {
public:
  /// Makes the file unless another rank has made it. @throws Error if it cannot be written.
  explicit LogFile(std::filesystem::path file);
  ~LogFile();
  LogFile(const LogFile&) = delete;
  LogFile& operator=(const LogFile&) = delete;

  /// Nothing is written any more. @throws Error if a part could not be written.
  void close();

  /// Writes `text` to the file that is open, if there is one.
  static void add(const std::string& text);

private:
  void write(const std::string& text);

  const std::filesystem::path file_;
  int descriptor_ = -1;
  bool is_complete_ = true;
};

} // namespace prosup

#endif
