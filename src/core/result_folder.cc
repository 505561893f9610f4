#include "prosup/core/result_folder.h"

#include <unistd.h>

#include "prosup/core/error.h"

namespace prosup {

namespace fs = std::filesystem;

namespace {

fs::path without_trailing_slash(const fs::path& path) {
  return path.has_filename() ? path : path.parent_path();
}

} // namespace

ResultFolder::ResultFolder(const fs::path& target)
    : target_(without_trailing_slash(fs::absolute(target).lexically_normal())) {
  std::error_code error;
  if (fs::exists(target_) && !fs::is_directory(target_))
    throw Error("The output folder '" + target.string() +
                "' is a file; give the name of a folder with --output.");
  if (fs::exists(target_) && !fs::is_empty(target_) && !fs::exists(target_ / "summary.json"))
    throw Error("The output folder '" + target.string() +
                "' exists and holds no earlier result (no summary.json); choose another folder "
                "with --output or empty this one.");
  fs::create_directories(target_.parent_path(), error);
  temporary_ = target_.parent_path() /
               ("." + target_.filename().string() + ".incomplete-" + std::to_string(getpid()));
  fs::remove_all(temporary_, error);
  fs::create_directory(temporary_, error);
  if (error)
    throw Error("The folder for results '" + temporary_.string() +
                "' cannot be created: " + error.message() + "; choose another with --output.");
}

ResultFolder::~ResultFolder() {
  std::error_code ignored;
  if (!committed_)
    fs::remove_all(temporary_, ignored);
}

void ResultFolder::commit() {
  std::error_code error;
  fs::remove_all(target_, error);
  if (!error)
    fs::rename(temporary_, target_, error);
  if (error)
    throw Error("The results in '" + temporary_.string() + "' cannot be moved to '" +
                target_.string() + "': " + error.message() + ".");
  committed_ = true;
}

} // namespace prosup
