#include "report_parameters.h"

#include <fstream>

#include "html.h"
#include "prosup/core/error.h"
#include "prosup/core/text.h"

namespace prosup::output {

std::vector<UsedParameter> read_used_parameters(const std::filesystem::path& result) {
  std::ifstream stream(result / "used.prm");
  if (!stream)
    throw Error("The folder '" + result.string() +
                "' holds no used.prm; give the --output folder of prosup register.");
  std::vector<UsedParameter> used;
  std::vector<std::string> sections;
  for (std::string line; std::getline(stream, line);) {
    line = trimmed(line);
    if (line.rfind("subsection ", 0) == 0)
      sections.push_back(line.substr(11));
    else if (line == "end" && !sections.empty())
      sections.pop_back();
    const std::size_t equals = line.find('=');
    if (line.rfind("set ", 0) != 0 || equals == std::string::npos)
      continue;
    const std::size_t mark = line.find("# default:", equals);
    used.push_back({joined(sections, "/"), trimmed(line.substr(4, equals - 4)),
                    trimmed(line.substr(equals + 1, mark - equals - 1)),
                    mark == std::string::npos ? "" : trimmed(line.substr(mark + 10)),
                    mark != std::string::npos});
  }
  return used;
}

std::string changed_parameters(const std::vector<UsedParameter>& used) {
  std::vector<ReportRow> rows;
  for (const UsedParameter& parameter : used)
    if (parameter.differs && parameter.section != "Case")
      rows.push_back({parameter.section + "/" + parameter.entry, parameter.value,
                      "default: " + (parameter.initial.empty() ? "none" : parameter.initial)});
  return rows.empty() ? "<p>None, apart from those above.</p>\n" : html::table(rows);
}

} // namespace prosup::output
