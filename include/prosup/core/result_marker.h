#ifndef PROSUP_CORE_RESULT_MARKER_H
#define PROSUP_CORE_RESULT_MARKER_H

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "prosup/core/checksum.h"

namespace prosup {

/// What prosup has written to a result folder, as a file in that folder. Only files that it lists
/// and that nobody has changed since may be replaced or removed.
class ResultMarker {
public:
  /// Of the marker, in the folder.
  static constexpr const char* file_name = ".prosup-result.json";

  /// A file that was written.
  struct Entry {
    std::string name; ///< relative to the folder, with '/' between folders
    FileDigest digest;
  };

  /// False while a result is being replaced: then a name may be listed twice, as it was and as it
  /// will be.
  bool complete = true;
  std::vector<Entry> files;

  /// The names of all files.
  std::vector<std::string> names() const;
  /// Whether there is a file of that name.
  bool lists(const std::string& name) const;
  /// Whether the file of that name in `folder` is one that is listed and has not changed.
  bool owns(const std::filesystem::path& folder, const std::string& name) const;

  /// The files below `folder`, flushed to the disk. @throws Error if one of them cannot be.
  static ResultMarker of(const std::filesystem::path& folder);
  /// The marker of a folder; nothing if it has none that can be read.
  static std::optional<ResultMarker> read(const std::filesystem::path& folder);
  /// Replaces the marker of a folder, at once. @throws Error if it cannot be written.
  void write(const std::filesystem::path& folder) const;

  /// JSON, and back; nothing if it is none of a marker, or names files outside of its folder.
  std::string text() const;
  static std::optional<ResultMarker> parse(const std::string& text);
};

} // namespace prosup

#endif
