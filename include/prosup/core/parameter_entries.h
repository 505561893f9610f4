#ifndef PROSUP_CORE_PARAMETER_ENTRIES_H
#define PROSUP_CORE_PARAMETER_ENTRIES_H

#include <deal.II/base/parameter_handler.h>

#include <map>
#include <string>

namespace prosup {

/// The values of all parameters by their paths, "Section/Subsection/Entry".
using ParameterEntries = std::map<std::string, std::string>;
ParameterEntries parameter_entries(const dealii::ParameterHandler& parameters);

} // namespace prosup

#endif
