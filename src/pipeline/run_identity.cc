#include "run_identity.h"

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "prosup/core/checksum.h"
#include "prosup/core/parameter_entries.h"
#include "prosup/core/text.h"
#include "prosup/image/image_files.h"

namespace prosup::pipeline {

using namespace dealii;

namespace {

/// Whether the value of an entry is a file to read.
bool is_input_file(const std::string& entry) {
  if (entry.rfind("Case/", 0) == 0)
    for (const char* end : {" image", " labels", " excluded", "/Landmarks"})
      if (ends_with(entry, end))
        return true;
  if (entry.rfind("Scans/", 0) == 0)
    return entry != "Scans/Series";
  return entry == "Single state/Mesh";
}

/// Of a file and, if it is an image, of all that holds its voxels.
std::string digest_of_input(const std::string& file) {
  if (file.empty())
    return "none";
  if (!std::filesystem::exists(file))
    return "missing";
  if (!std::filesystem::is_directory(file))
    return digest_text(image::files_of_image(file));
  std::vector<std::filesystem::path> slices; // of a folder of DICOM files
  for (const auto& entry : std::filesystem::recursive_directory_iterator(file))
    if (entry.is_regular_file())
      slices.push_back(entry.path());
  std::sort(slices.begin(), slices.end());
  return digest_text(slices);
}

std::string line_of(const std::string& name, const std::string& value) {
  return name + " = " + value + "\n";
}

ParameterEntries entries_of(const std::string& text) {
  ParameterEntries entries;
  for (const std::string& line : Utilities::split_string_list(text, "\n")) {
    const std::size_t equals = line.find(" =");
    if (equals != std::string::npos)
      entries[line.substr(0, equals)] = Utilities::trim(line.substr(equals + 2));
  }
  return entries;
}

} // namespace

RunIdentity identity_of(const ParameterHandler& all) {
  RunIdentity identity;
  for (const auto& [name, value] : parameter_entries(all))
    if (is_input_file(name))
      identity.inputs += line_of(name, digest_of_input(value));
    else if (name.rfind("Checkpoint/", 0) != 0)
      identity.parameters += line_of(name, value);
  return identity;
}

std::string first_difference(const RunIdentity& then, const RunIdentity& now,
                             const std::string& where) {
  const ParameterEntries old = entries_of(then.parameters), old_inputs = entries_of(then.inputs);
  for (const auto& [name, value] : entries_of(now.parameters)) {
    const auto found = old.find(name);
    const std::string before = found == old.end() ? "" : found->second;
    if (found == old.end() || before != value)
      return "The parameter '" + name + "' is '" + value + "', but '" + before + "' " + where +
             "; give the old value";
  }
  for (const auto& [name, value] : entries_of(now.inputs)) {
    const auto found = old_inputs.find(name);
    if (found == old_inputs.end() || found->second != value)
      return "The file of '" + name + "' has other contents than that " + where +
             "; give the old file";
  }
  return "";
}

} // namespace prosup::pipeline
