#include "prosup/core/result_folder.h"

#include "prosup/core/error.h"
#include "prosup/core/file_system.h"
#include "result_replacement.h"

namespace prosup {

namespace fs = std::filesystem;

namespace {

fs::path unfinished_inside(const fs::path& target) {
  return target / unfinished_name(target, "prosup");
}

fs::path unfinished_beside(const fs::path& target) {
  return target.parent_path() / unfinished_name(target.parent_path(), target.filename().string());
}

bool is_folder(const fs::path& path) {
  std::error_code error;
  return fs::is_directory(path, error);
}

} // namespace

ResultFolder::ResultFolder(ResultTarget target, std::vector<std::string> names)
    : target_(std::move(target)), names_(std::move(names)) {
  const std::string given = target_.folder.string();
  target_.folder = without_links(target_.folder);
  std::error_code error;
  if (fs::exists(target_.folder, error) && !is_folder(target_.folder))
    throw Error("The output folder '" + given +
                "' is a file; give the name of a folder with --output.");
  const bool is_there = is_folder(target_.folder);
  if (is_there)
    ResultReplacement(target_).check(names_);
  else if (fs::create_directories(target_.folder, error); !error)
    fs::remove(target_.folder); // this only shows early that it can be made
  if (error)
    throw Error("The output folder '" + given + "' cannot be created (" + error.message() +
                "); choose another with --output.");
  if (const fs::path beside = unfinished_beside(target_.folder); is_there && is_folder(beside))
    const FolderLock other(beside, given); // a run that began before the folder was there
  lock_ = std::make_unique<FolderLock>(
      is_there ? unfinished_inside(target_.folder) : unfinished_beside(target_.folder), given);
  unfinished_ = std::make_unique<Unfinished>([this] { lock_->clear(); });
  name_ = std::make_unique<TemporaryName>(path(), given);
}

ResultFolder::~ResultFolder() {
  const auto lock = uninterrupted();
  unfinished_.reset();
  lock_.reset();
}

void ResultFolder::commit() {
  const auto lock = uninterrupted();
  const fs::path& folder = target_.folder;
  const ResultMarker fresh = ResultMarker::of(path());
  if (!is_folder(folder)) {
    fresh.write(path());
    std::error_code error;
    fs::rename(path(), folder, error);
    if (error && !is_folder(folder))
      throw Error("The results cannot be moved to '" + folder.string() + "' (" + error.message() +
                  "); choose another folder with --output.");
  }
  if (is_folder(path())) { // the target is there, maybe since a moment ago
    std::unique_ptr<FolderLock> there;
    if (lock_->folder() != unfinished_inside(folder))
      there = std::make_unique<FolderLock>(unfinished_inside(folder), folder.string());
    const ResultReplacement replacement(target_);
    try {
      replacement.check(fresh.names());
    } catch (const Error& error) {
      keep_aside(error.what());
    }
    replacement.move_in(path(), fresh);
  }
  unfinished_.reset();
  lock_.reset();
}

void ResultFolder::keep_aside(const std::string& reason) const {
  fs::path place;
  for (unsigned n = 1; n == 1 || fs::exists(fs::symlink_status(place)); ++n)
    place = target_.folder / ("prosup-result-" + std::to_string(n));
  ResultMarker::of(path()).write(path());
  fs::rename(path(), place);
  throw Error(reason.substr(0, reason.rfind(';')) + "; the results are in '" + place.string() +
              "' instead.");
}

bool ResultFolder::clear_leftover(const fs::path& folder) {
  const fs::path target = without_links(folder);
  const bool inside = FolderLock::clear_leftover(unfinished_inside(target));
  return FolderLock::clear_leftover(unfinished_beside(target)) || inside;
}

} // namespace prosup
