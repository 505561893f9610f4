#ifndef PROSUP_CORE_RESULT_FOLDER_H
#define PROSUP_CORE_RESULT_FOLDER_H

#include <filesystem>

namespace prosup {

/// A result folder that is written completely or not at all. Files are written to path(), a hidden
/// temporary folder beside the target. commit() moves it to the target and replaces an earlier
/// result of this program. Without commit() the destructor deletes it. For use on one rank.
class ResultFolder {
public:
  /// @throws Error if the target is not empty and has no summary.json, that is, if it is not an
  /// earlier result, or if its parent folder cannot be written.
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
