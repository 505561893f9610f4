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

/// Declares the parameters of all ParameterAcceptor objects alive, reads
/// `file` (none if empty) strictly, applies the overrides in their order and
/// gives every object its values.
/// @throws Error that names the file, line, entry and what is allowed.
void read_parameters(dealii::ParameterHandler& parameters, const std::filesystem::path& file,
                     const std::vector<Override>& overrides);

/// The same with a handler of its own, for programs that need none.
void read_parameters(const std::filesystem::path& file,
                     const std::vector<Override>& overrides = {});

/// Makes the file names in these entries of a section absolute: a name that is
/// not is relative to `folder`; an empty one stays empty.
void resolve_files(dealii::ParameterHandler& parameters, const std::string& section,
                   const std::vector<std::string>& entries, const std::filesystem::path& folder);

/// Writes all parameters with values, units and documentation to `file`.
void write_parameters(const dealii::ParameterHandler& parameters,
                      const std::filesystem::path& file);

/// Pattern of a value that is one of `names`.
dealii::Patterns::Selection one_of(const std::vector<std::string>& names);

/// The enumerator whose place in its list of names is that of `name`.
template <typename Enumerator>
Enumerator enumerator(const std::string& name, const std::vector<std::string>& names) {
  return static_cast<Enumerator>(std::find(names.begin(), names.end(), name) - names.begin());
}

} // namespace prosup

#endif
