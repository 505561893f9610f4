#include "planned_runs.h"

#include <deal.II/base/utilities.h>

#include <set>

#include "prosup/core/error.h"

namespace prosup::pipeline {

using dealii::Utilities::replace_in_string;
using dealii::Utilities::split_string_list;
using dealii::Utilities::trim;

namespace {

[[noreturn]] void refuse(const std::string& run) {
  throw Error("The run '" + run +
              "' in 'Comparison/Runs' cannot be read; write 'group/name: arguments' or "
              "'group/name, name: arguments', with semicolons between runs.");
}

/// The parts between semicolons that do not stand in quotes.
std::vector<std::string> parts_of(const std::string& text) {
  std::vector<std::string> parts(1);
  bool quoted = false;
  for (const char c : text) {
    quoted = quoted != (c == '"');
    if (c == ';' && !quoted)
      parts.emplace_back();
    else
      parts.back() += c;
  }
  return parts;
}

} // namespace

std::vector<std::string> words_of(const std::string& text) {
  std::vector<std::string> words;
  bool quoted = false, in_word = false;
  for (const char c : text) {
    if (c == '"')
      quoted = !quoted;
    if (!quoted && std::isspace(static_cast<unsigned char>(c))) {
      in_word = false;
      continue;
    }
    if (!in_word)
      words.emplace_back();
    in_word = true;
    if (c != '"')
      words.back() += c;
  }
  if (quoted)
    throw Error("A double quote does not end in the arguments '" + trim(text) +
                "' of section Comparison; write \"Section/Entry=value\".");
  return words;
}

std::vector<PlannedRun> planned_runs(const std::string& text) {
  std::vector<PlannedRun> runs;
  std::set<std::string> seen;
  for (const std::string& part : parts_of(text)) {
    const std::string run = trim(part);
    if (run.empty())
      continue;
    const std::size_t colon = run.find(':'), slash = run.find('/');
    if (colon == std::string::npos || slash == std::string::npos || slash > colon)
      refuse(run);
    const std::string group = trim(run.substr(0, slash));
    const std::vector<std::string> names =
        split_string_list(run.substr(slash + 1, colon - slash - 1), ',');
    if (group.empty() || names.empty())
      refuse(run);
    for (const std::string& name : names) {
      if (name.empty())
        refuse(run);
      if (!seen.insert(group + "/" + name).second)
        throw Error("The run '" + group + "/" + name +
                    "' stands twice in 'Comparison/Runs'; give it another name.");
      runs.push_back({group, name, words_of(replace_in_string(run.substr(colon + 1), "$", name))});
    }
  }
  return runs;
}

} // namespace prosup::pipeline
