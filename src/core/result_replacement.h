#ifndef PROSUP_SRC_CORE_RESULT_REPLACEMENT_H
#define PROSUP_SRC_CORE_RESULT_REPLACEMENT_H

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "prosup/core/result_folder.h"
#include "prosup/core/result_marker.h"

namespace prosup {

/// Puts a new result into a folder that exists.
class ResultReplacement {
public:
  explicit ResultReplacement(const ResultTarget& target);

  /// @throws Error if one of these files is in the way of a new one, or is read by the run.
  void check(const std::vector<std::string>& names) const;

  /// Moves the files of `source`, which `fresh` lists and which have been checked, into the folder.
  /// Stopped at any point, it leaves a folder without summary.json, whose marker lists the files of
  /// both results. @throws Error if a file cannot be moved.
  void move_in(const std::filesystem::path& source, const ResultMarker& fresh) const;

private:
  /// Whether prosup may replace what is there under this name.
  bool may_replace(const std::string& name) const;
  void refuse_inputs(const std::vector<std::string>& names) const;
  void remove_earlier(const ResultMarker& fresh) const;

  const ResultTarget& target_;
  ResultMarker earlier_;
};

} // namespace prosup

#endif
