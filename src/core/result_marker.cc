#include "prosup/core/result_marker.h"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "prosup/core/error.h"
#include "prosup/core/file_system.h"
#include "prosup/core/text_file.h"
#include "prosup/core/version.h"

namespace prosup {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

constexpr int layout = 1; // of the marker

/// Whether a name leads to a file below the folder it is relative to.
bool stays_inside(const std::string& name) {
  const fs::path path(name);
  return !name.empty() && name.find('\0') == std::string::npos && path.is_relative() &&
         path.has_filename() && std::none_of(path.begin(), path.end(), [](const fs::path& part) {
           return part == ".." || part == ".";
         });
}

std::optional<ResultMarker::Entry> entry_of(const Json& json) {
  if (!json.is_object())
    return {};
  const auto name = json.find("name"), size = json.find("size"), crc = json.find("crc32");
  if (name == json.end() || size == json.end() || crc == json.end() || !name->is_string() ||
      !size->is_number_unsigned() || !crc->is_number_unsigned() ||
      crc->get<std::uint64_t>() > UINT32_MAX || !stays_inside(name->get<std::string>()))
    return {};
  return ResultMarker::Entry{name->get<std::string>(),
                             {size->get<std::uint64_t>(), crc->get<std::uint32_t>()}};
}

} // namespace

std::vector<std::string> ResultMarker::names() const {
  std::vector<std::string> all;
  for (const Entry& entry : files)
    all.push_back(entry.name);
  return all;
}

bool ResultMarker::lists(const std::string& name) const {
  return std::any_of(files.begin(), files.end(), [&](const Entry& e) { return e.name == name; });
}

bool ResultMarker::owns(const fs::path& folder, const std::string& name) const {
  std::error_code error;
  if (!fs::is_regular_file(fs::symlink_status(folder / name, error)))
    return false;
  const std::uintmax_t size = fs::file_size(folder / name, error);
  if (error || std::none_of(files.begin(), files.end(), [&](const Entry& e) {
        return e.name == name && e.digest.size == size;
      }))
    return false; // without reading it
  const FileDigest found = digest_of(folder / name);
  return std::any_of(files.begin(), files.end(),
                     [&](const Entry& e) { return e.name == name && e.digest == found; });
}

ResultMarker ResultMarker::of(const fs::path& folder) {
  ResultMarker marker;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file() || entry.path() == folder / file_name)
      continue;
    flush_to_disk(entry.path());
    marker.files.push_back(
        {entry.path().lexically_relative(folder).generic_string(), digest_of(entry.path())});
  }
  std::sort(marker.files.begin(), marker.files.end(),
            [](const Entry& a, const Entry& b) { return a.name < b.name; });
  return marker;
}

std::optional<ResultMarker> ResultMarker::read(const fs::path& folder) {
  std::ifstream stream(folder / file_name, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return parse(text.str());
}

void ResultMarker::write(const fs::path& folder) const {
  const fs::path file = folder / file_name, next = folder / (std::string(file_name) + ".next");
  write_text_file(text(), next);
  flush_to_disk(next);
  std::error_code error;
  fs::rename(next, file, error);
  if (error)
    throw Error("The file '" + file.string() + "' cannot be replaced: " + error.message() + ".");
}

std::string ResultMarker::text() const {
  Json json;
  json["what"] = "Files that prosup has written to this folder. It replaces them as long as they "
                 "are as they were, and leaves all others alone.";
  json["layout"] = layout;
  json["version"] = version();
  json["complete"] = complete;
  json["files"] = Json::array();
  for (const Entry& entry : files)
    json["files"].push_back(
        {{"name", entry.name}, {"size", entry.digest.size}, {"crc32", entry.digest.crc32}});
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::optional<ResultMarker> ResultMarker::parse(const std::string& text) {
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object() || json.value("layout", Json()) != layout ||
      !json.value("complete", Json()).is_boolean() || !json.value("files", Json()).is_array())
    return {};
  ResultMarker marker;
  marker.complete = json["complete"].get<bool>();
  for (const Json& file : json["files"]) {
    const auto entry = entry_of(file);
    if (!entry)
      return {};
    marker.files.push_back(*entry);
  }
  return marker;
}

} // namespace prosup
