#ifndef PROSUP_PIPELINE_PLANNED_RUNS_H
#define PROSUP_PIPELINE_PLANNED_RUNS_H

#include <string>
#include <vector>

namespace prosup::pipeline {

/// A run of prosup that a comparison asks for.
struct PlannedRun {
  std::string group, name;
  std::vector<std::string> arguments;
};

/// Words between blanks; what stands in double quotes is one word.
/// @throws Error if a quote does not end.
std::vector<std::string> words_of(const std::string& text);

/// Reads 'group/name, name: arguments; ...'; a $ in the arguments is the name.
/// @throws Error that shows the run and how it should be written.
std::vector<PlannedRun> planned_runs(const std::string& text);

} // namespace prosup::pipeline

#endif
