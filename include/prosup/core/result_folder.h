#ifndef PROSUP_CORE_RESULT_FOLDER_H
#define PROSUP_CORE_RESULT_FOLDER_H

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "prosup/core/folder_lock.h"
#include "prosup/core/temporary_name.h"
#include "prosup/core/unfinished.h"

namespace prosup {

/// Where results go, and what must not be harmed there.
struct ResultTarget {
  // Implicit, so that a plain folder will do.
  ResultTarget(std::filesystem::path folder_, bool overwrite_ = false,
               std::vector<std::filesystem::path> inputs_ = {})
      : folder(std::move(folder_)), overwrite(overwrite_), inputs(std::move(inputs_)) {}

  std::filesystem::path folder;
  bool overwrite; ///< also files that prosup did not write, or that have changed since
  std::vector<std::filesystem::path> inputs; ///< what the run reads
};

/// A result folder that is written completely or not at all. Files are written to path(), a hidden
/// temporary folder. commit() moves them to the target, next to what is there already, and removes
/// of an earlier result what is left of it. Without commit() the destructor deletes them. Files
/// that prosup did not write, or that have changed since (ResultMarker), stay as they are. For use
/// on one rank.
///
/// The temporary folder lies in the target if that exists, so that nothing is ever moved between
/// file systems, and beside it otherwise. One process at a time has it (FolderLock).
class ResultFolder {
public:
  /// `names` are the files that may be written, relative to the folder; one with '/' at its end
  /// stands for all files in a folder.
  /// @throws Error if one of them is an input, or would replace a file that prosup did not write,
  /// if another run writes there, or if the folder cannot be made.
  explicit ResultFolder(ResultTarget target, std::vector<std::string> names = {});
  ~ResultFolder();
  ResultFolder(const ResultFolder&) = delete;
  ResultFolder& operator=(const ResultFolder&) = delete;

  std::filesystem::path path() const { return lock_->work(); }

  /// @throws Error if a file cannot be moved. If one is in the way by now, the results go to a
  /// folder of their own in the target, which the message names.
  void commit();

  /// Removes what an ended process has left of a result for this folder, if no process is at work
  /// on it. @returns whether there was anything.
  static bool clear_leftover(const std::filesystem::path& folder);

private:
  /// Results that took long are not lost because something got in their way since the start.
  [[noreturn]] void keep_aside(const std::string& reason) const;

  ResultTarget target_; // its folder without links
  std::vector<std::string> names_;
  std::unique_ptr<FolderLock> lock_;
  std::unique_ptr<Unfinished> unfinished_;
  std::unique_ptr<TemporaryName> name_;
};

} // namespace prosup

#endif
