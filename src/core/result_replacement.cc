#include "result_replacement.h"

#include <algorithm>

#include "prosup/core/error.h"
#include "prosup/core/file_system.h"

namespace prosup {

namespace fs = std::filesystem;

namespace {

constexpr const char* summary = "summary.json"; // what makes a result look whole

bool is_there(const fs::path& file) {
  std::error_code error;
  return fs::exists(fs::symlink_status(file, error)); // also a link that leads nowhere
}

bool is_folder(const fs::path& file) {
  std::error_code error;
  return fs::is_directory(fs::symlink_status(file, error));
}

/// The folders that a name goes through, relative to the result.
std::vector<fs::path> folders_of(const std::string& name) {
  std::vector<fs::path> folders;
  for (fs::path part = fs::path(name).parent_path(); !part.empty(); part = part.parent_path())
    folders.push_back(part);
  return folders;
}

/// The names, with those that stand for a folder replaced by what it holds.
std::vector<std::string> expanded(const std::vector<std::string>& names, const fs::path& folder) {
  std::vector<std::string> all;
  for (const std::string& name : names) {
    if (name.back() != '/' || !is_folder(folder / name.substr(0, name.size() - 1))) {
      all.push_back(name.back() == '/' ? name.substr(0, name.size() - 1) : name);
      continue;
    }
    std::error_code error;
    for (const auto& entry : fs::recursive_directory_iterator(folder / name, error))
      if (!entry.is_directory())
        all.push_back(entry.path().lexically_relative(folder).generic_string());
  }
  return all;
}

void put_into_place(const fs::path& from, const fs::path& to) {
  std::error_code error;
  fs::create_directories(to.parent_path(), error);
  fs::rename(from, to, error);
  if (error)
    throw Error("The file '" + to.string() + "' of the new result cannot be put into place (" +
                error.message() +
                "); the folder holds parts of two results now, so run again when that is mended.");
}

} // namespace

ResultReplacement::ResultReplacement(const ResultTarget& target)
    : target_(target), earlier_(ResultMarker::read(target.folder).value_or(ResultMarker())) {}

bool ResultReplacement::may_replace(const std::string& name) const {
  const fs::path file = target_.folder / name;
  for (const fs::path& folder : folders_of(name))
    if (is_there(target_.folder / folder) && !is_folder(target_.folder / folder))
      return false;
  if (!is_there(file))
    return true;
  if (is_folder(file))
    return false;
  return target_.overwrite || earlier_.owns(target_.folder, name);
}

void ResultReplacement::refuse_inputs(const std::vector<std::string>& names) const {
  for (const std::string& name : names)
    if (const fs::path input = input_at(target_.folder / name, target_.inputs); !input.empty())
      throw Error("The input '" + input.string() + "' is the file '" + name +
                  "' of the output folder '" + target_.folder.string() +
                  "', which this run would replace; choose another folder with --output.");
}

void ResultReplacement::check(const std::vector<std::string>& names) const {
  std::vector<std::string> all = expanded(names, target_.folder);
  refuse_inputs(all);
  refuse_inputs(earlier_.names()); // which are removed
  all.erase(std::remove_if(all.begin(), all.end(),
                           [&](const std::string& name) { return may_replace(name); }),
            all.end());
  if (!ResultMarker::read(target_.folder) && !target_.overwrite &&
      is_there(target_.folder / ResultMarker::file_name))
    all.push_back(ResultMarker::file_name);
  if (all.empty())
    return;
  const std::size_t n = all.size();
  throw Error("In the output folder '" + target_.folder.string() + "', '" + all.front() + "'" +
              (n == 1 ? " is" : " and others (" + std::to_string(n) + " files) are") +
              " in the way of the results and not as prosup has written " +
              (n == 1 ? "it" : "them") + "; choose another folder with --output, or replace " +
              (n == 1 ? "the file" : "these files") + " with --overwrite.");
}

void ResultReplacement::remove_earlier(const ResultMarker& fresh) const {
  std::error_code ignored;
  for (const ResultMarker::Entry& entry : earlier_.files) {
    if (!fresh.lists(entry.name) && earlier_.owns(target_.folder, entry.name))
      fs::remove(target_.folder / entry.name, ignored);
    for (const fs::path& folder : folders_of(entry.name))
      fs::remove(target_.folder / folder, ignored); // fails unless it is empty
  }
}

void ResultReplacement::move_in(const fs::path& source, const ResultMarker& fresh) const {
  std::vector<std::string> names = fresh.names();
  ResultMarker both = fresh;
  both.complete = false;
  both.files.insert(both.files.end(), earlier_.files.begin(), earlier_.files.end());
  both.write(target_.folder);
  std::error_code ignored;
  if (may_replace(summary))
    fs::remove(target_.folder / summary, ignored);
  remove_earlier(fresh);
  std::stable_partition(names.begin(), names.end(),
                        [](const std::string& name) { return name != summary; });
  for (const std::string& name : names)
    put_into_place(source / name, target_.folder / name);
  fresh.write(target_.folder);
}

} // namespace prosup
