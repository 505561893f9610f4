#ifndef PROSUP_CORE_PARAMETERS_H
#define PROSUP_CORE_PARAMETERS_H

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace prosup {

/// One override from the command line: "Section/Subsection/Entry=value".
using Override = std::string;

/// Declares the parameters of all existing ParameterAcceptor objects, reads `file` (if not empty),
/// applies the overrides in order, and passes the values to the objects. Unknown sections and
/// entries are errors.
/// @throws Error that names the file, the line, the entry and the allowed values.
void read_parameters(dealii::ParameterHandler& parameters, const std::filesystem::path& file,
                     const std::vector<Override>& overrides);

/// The same with a handler of its own, for programs that need none.
void read_parameters(const std::filesystem::path& file,
                     const std::vector<Override>& overrides = {});

/// Makes the file names in these entries of a section absolute. Relative names are relative to
/// `folder`; empty ones stay empty.
void resolve_files(dealii::ParameterHandler& parameters, const std::string& section,
                   const std::vector<std::string>& entries, const std::filesystem::path& folder);

/// Writes all parameters with values, units and documentation to `file`.
void write_parameters(const dealii::ParameterHandler& parameters,
                      const std::filesystem::path& file);

/// Writes a table of all parameters with defaults, what they allow, and documentation to `file`, in
/// Markdown. @throws Error if it cannot be written.
void write_parameter_reference(const dealii::ParameterHandler& parameters,
                               const std::filesystem::path& file);

/// Pattern for a value that must be one of `names`.
dealii::Patterns::Selection one_of(const std::vector<std::string>& names);

/// The enumerator at the position of `name` in the list of names.
template <typename Enumerator>
Enumerator enumerator(const std::string& name, const std::vector<std::string>& names) {
  return static_cast<Enumerator>(std::find(names.begin(), names.end(), name) - names.begin());
}

} // namespace prosup

#endif
