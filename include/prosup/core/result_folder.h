#ifndef PROSUP_CORE_RESULT_FOLDER_H
#define PROSUP_CORE_RESULT_FOLDER_H

#include <filesystem>

namespace prosup {

/// Writes results all or not at all. Files go to path(), a hidden temporary
/// folder beside the target; commit() moves it to the target, replacing an
/// earlier result of this program. Without commit() the destructor deletes it.
/// For use on one rank.
class ResultFolder {
public:
  /// @throws Error if the target exists and is no earlier result (it has no
  /// summary.json and is not empty), or if its parent cannot be written.
  explicit ResultFolder(const std::filesystem::path& target);
  ~ResultFolder();
  ResultFolder(const ResultFolder&) = delete;
  ResultFolder& operator=(const ResultFolder&) = delete;

  const std::filesystem::path& path() const { return temporary_; }

  void commit();

private:
  std::filesystem::path target_;
  std::filesystem::path temporary_;
  bool committed_ = false;
};

} // namespace prosup

#endif
