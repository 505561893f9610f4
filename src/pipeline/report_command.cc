#include <algorithm>

#include "prosup/core/error.h"
#include "prosup/core/output_file.h"
#include "prosup/core/parameters.h"
#include "prosup/core/result_marker.h"
#include "prosup/pipeline/all_parameters.h"
#include "prosup/pipeline/commands.h"
#include "prosup/pipeline/finished_result.h"
#include "result_report.h"

namespace prosup::pipeline {

namespace fs = std::filesystem;

namespace {

/// The images that the run started from, if they are still there.
std::optional<registration::Inputs> read_inputs(const fs::path& result, Remarks& remarks) {
  try {
    AllParameters parameters;
    dealii::ParameterHandler handler;
    read_parameters(handler, result / "used.prm", {});
    return parameters.registration.images.read_pair(parameters.case_files.files(), MPI_COMM_SELF,
                                                    remarks);
  } catch (const Error& error) {
    remarks.add(std::string("The report has no slices to compare, since the inputs of the run "
                            "cannot be read: ") +
                error.what());
    return {};
  }
}

/// Lists the new report among the files that prosup may replace.
void list(const fs::path& result) {
  std::optional<ResultMarker> marker = ResultMarker::read(result);
  if (!marker)
    return;
  auto& files = marker->files;
  files.erase(std::remove_if(files.begin(), files.end(),
                             [](const auto& entry) { return entry.name == output::report_html; }),
              files.end());
  files.push_back({output::report_html, digest_of(result / output::report_html)});
  marker->write(result);
}

} // namespace

void run_report(const ReportRequest& request) {
  if (!fs::is_directory(request.result))
    throw Error("'" + request.result.string() +
                "' is no folder; give the --output folder of prosup register.");
  require_finished(request.result);
  const fs::path file = request.result / output::report_html;
  const auto marker = ResultMarker::read(request.result);
  if (fs::exists(fs::symlink_status(file)) && !request.overwrite &&
      !(marker && marker->owns(request.result, output::report_html)))
    throw Error("The file '" + file.string() +
                "' is not as prosup has written it; move it away, or replace it with --overwrite.");
  Remarks remarks{Log(MPI_COMM_SELF)};
  const auto inputs = read_inputs(request.result, remarks);
  write_result_report(request.result, inputs ? report_images(inputs->originals)
                                             : std::optional<output::ReportImages>());
  list(request.result);
}

} // namespace prosup::pipeline
