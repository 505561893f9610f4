#ifndef PROSUP_CORE_FOLDER_LOCK_H
#define PROSUP_CORE_FOLDER_LOCK_H

#include <filesystem>
#include <string>

namespace prosup {

/// A folder that one process at a time has for its unfinished work. The lock is the kernel's: it
/// goes with the process, however that ends, so that the next one can clear away what is left.
class FolderLock {
public:
  /// Makes the folder or takes it over, and removes what an ended process has left in it.
  /// @throws Error if a process that works on `what` holds it, if somebody else's files are in it,
  /// or if it cannot be made.
  FolderLock(std::filesystem::path folder, const std::string& what);
  /// Removes the folder.
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

  const std::filesystem::path& folder() const { return folder_; }
  /// An empty folder inside, for the work.
  std::filesystem::path work() const { return folder_ / "result"; }

  /// Removes the folder, for a process that is about to end.
  void clear() const;

  /// Removes what an ended process has left in `folder`, if no process holds it.
  /// @returns whether there was anything.
  static bool clear_leftover(const std::filesystem::path& folder);

private:
  std::filesystem::path folder_;
  int descriptor_ = -1;
};

} // namespace prosup

#endif
