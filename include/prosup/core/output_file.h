#ifndef PROSUP_CORE_OUTPUT_FILE_H
#define PROSUP_CORE_OUTPUT_FILE_H

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "prosup/core/temporary_name.h"
#include "prosup/core/unfinished.h"

namespace prosup {

/// What a command with a single output file may do.
struct OutputFileRules {
  std::vector<std::filesystem::path> inputs; ///< what the run reads, which is never replaced
  bool overwrite = false;                    ///< whatever else there is
  /// Of files that the command writes, which it may replace. Without one it replaces only a file
  /// that has the same contents.
  std::string first_line;
  std::vector<std::string> other_first_lines{}; ///< of files that it writes in other cases
  std::string ending{}; ///< of the temporary file, for libraries that choose the format by it
};

/// A single output file that is written completely or not at all: to path(), a temporary file
/// beside it, which commit() moves to its place. Devices and pipes are written to directly. A link
/// is followed and stays. For use on one rank.
class OutputFile {
public:
  /// @throws Error if the file is a folder, an input or something that may not be replaced, or if
  /// it cannot be made.
  OutputFile(const std::filesystem::path& file, OutputFileRules rules);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  const std::filesystem::path& path() const { return temporary_; }

  /// @throws Error if the file cannot be moved or replaced.
  void commit();

private:
  void check() const;
  bool is_ours(const std::string& line) const;
  void make_temporary();
  [[noreturn]] void throw_in_the_way() const;

  const std::filesystem::path given_;
  const OutputFileRules rules_;
  std::filesystem::path file_;      ///< without links
  std::filesystem::path temporary_; ///< is file_ if that is written to directly
  int lock_ = -1;
  std::unique_ptr<Unfinished> unfinished_;
  std::unique_ptr<TemporaryName> name_;
};

} // namespace prosup

#endif
