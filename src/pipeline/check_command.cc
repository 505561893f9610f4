#include "prosup/core/collective.h"
#include "prosup/core/log.h"
#include "prosup/pipeline/commands.h"

namespace prosup::pipeline {

bool run_check(const AllParameters& parameters, const dealii::ParameterHandler&,
               const ResultTarget&, MPI_Comm world) {
  const Log log(world);
  on_root(world, [&] { parameters.case_files.require_pair(); });
  registration::Registration registration(parameters.registration, world);
  registration.read(parameters.case_files.files());
  registration.align();
  const registration::SceneReport report = registration.check();
  on_root(world, [&] {
    log.line(report.measures);
    for (const registration::Finding& finding : report.findings)
      log.line(
          (finding.severity == registration::Finding::Severity::error ? "Error: " : "Warning: ") +
          finding.text);
    if (report.findings.empty())
      log.line("Nothing was found that speaks against a registration.");
    Remarks told_above;
    parameters.registration.checks.accept(report, told_above);
  });
  return true;
}

} // namespace prosup::pipeline
