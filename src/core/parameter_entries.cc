#include "prosup/core/parameter_entries.h"

#include <deal.II/base/utilities.h>

#include <sstream>
#include <vector>

#include "prosup/core/text.h"

namespace prosup {

using namespace dealii;

ParameterEntries parameter_entries(const ParameterHandler& parameters) {
  std::stringstream text;
  parameters.print_parameters(text,
                              ParameterHandler::ShortPRM | ParameterHandler::KeepDeclarationOrder);
  ParameterEntries entries;
  std::vector<std::string> sections;
  for (std::string line; std::getline(text, line);) {
    line = Utilities::trim(line);
    const std::string section = "subsection ", entry = "set ";
    if (line == "end")
      sections.pop_back();
    else if (line.rfind(section, 0) == 0)
      sections.push_back(line.substr(section.size()) + "/");
    else if (const std::size_t equals = line.find('=');
             line.rfind(entry, 0) == 0 && equals != std::string::npos)
      entries[joined(sections, "") +
              Utilities::trim(line.substr(entry.size(), equals - entry.size()))] =
          Utilities::trim(line.substr(equals + 1));
  }
  return entries;
}

} // namespace prosup
