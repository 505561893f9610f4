#include <algorithm>
#include <cstdio>

#include "prosup/core/error.h"
#include "prosup/core/file_system.h"
#include "prosup/core/log.h"
#include "prosup/core/output_file.h"
#include "prosup/core/text.h"
#include "prosup/core/text_file.h"
#include "prosup/output/result_table.h"
#include "prosup/pipeline/commands.h"
#include "shown_properties.h"

namespace prosup::pipeline {

namespace fs = std::filesystem;

namespace {

/// Named as in summary.json.
std::vector<output::TableColumn> property_columns() {
  std::vector<output::TableColumn> columns;
  for (const ShownProperty& property : shown_properties()) {
    std::string name = std::string(property.pointer).substr(1);
    std::replace(name.begin(), name.end(), '/', '_');
    const std::string unit = property.unit;
    columns.push_back({std::string("/material") + property.pointer, name,
                       property.name + (unit.empty() ? "" : ", " + unit)});
  }
  columns.push_back({"/material/supine_tilt/0", "supine_tilt_left", "Tilt to the left, degrees"});
  columns.push_back({"/material/supine_tilt/1", "supine_tilt_head", "Tilt to the head, degrees"});
  return columns;
}

bool is_page(const fs::path& output) {
  const std::string end = lower_case(output.extension().string());
  if (end == ".html" || end == ".htm")
    return true;
  if (end != ".csv")
    throw Error("The output '" + output.string() +
                "' ends neither in .csv nor in .html, which are what is written; give a name that "
                "does.");
  return false;
}

void write(const output::ResultTable& table, const TableRequest& request) {
  if (request.output.empty()) {
    std::printf("%s", table.csv().c_str());
    return;
  }
  const bool page = is_page(request.output);
  OutputFile file(request.output, {{}, request.overwrite, page ? table.page_mark : table.header()});
  const fs::path folder = absolute_path(request.output).parent_path();
  write_text_file(page ? table.html(folder) : table.csv(), file.path());
  file.commit();
}

} // namespace

void run_table(const TableRequest& request) {
  const output::ResultTable table(request.results, property_columns());
  write(table, request);
  if (const std::size_t n = table.n_unfinished(); n > 0)
    Log(MPI_COMM_SELF)
        .warning(format("%zu of %zu folders %s no finished registration; the table says why.", n,
                        request.results.size(), n == 1 ? "holds" : "hold"));
}

} // namespace prosup::pipeline
