#ifndef PROSUP_SRC_OUTPUT_REPORT_PARAMETERS_H
#define PROSUP_SRC_OUTPUT_REPORT_PARAMETERS_H

#include <filesystem>
#include <string>
#include <vector>

namespace prosup::output {

/// A parameter as used.prm has it; `differs` from the default.
struct UsedParameter {
  std::string section, entry, value, initial;
  bool differs = false;
};

/// All parameters of a result. @throws Error if it has no used.prm.
std::vector<UsedParameter> read_used_parameters(const std::filesystem::path& result);

/// Those that differ from their defaults, but for the section Case. HTML.
std::string changed_parameters(const std::vector<UsedParameter>& used);

} // namespace prosup::output

#endif
