#include "prosup/core/collective.h"
#include "prosup/core/log.h"
#include "prosup/pipeline/commands.h"
#include "prosup/pipeline/landmark_evaluation.h"

namespace prosup::pipeline {

bool run_check(const AllParameters& parameters, const dealii::ParameterHandler&,
               const ResultTarget&, MPI_Comm world) {
  const Log log(world);
  Remarks remarks(log);
  LandmarkEvaluation landmarks;
  on_root(world, [&] {
    parameters.case_files.require_pair();
    landmarks.read(parameters.case_files, remarks);
  });
  registration::Registration registration(parameters.registration, world);
  registration.read(parameters.case_files.files(), remarks);
  registration.align();
  const registration::SceneReport report = registration.check();
  on_root(world, [&] {
    for (const Position position : both_positions)
      landmarks.check_places(position, registration.inputs().originals[position].breast, remarks);
    log.line(report.measures);
    for (const registration::Finding& finding : report.findings)
      log.line(
          (finding.severity == registration::Finding::Severity::error ? "Error: " : "Warning: ") +
          finding.text);
    if (report.findings.empty() && remarks.all().empty())
      log.line("Nothing was found that speaks against a registration.");
    Remarks told_above;
    parameters.registration.checks.accept(report, told_above);
  });
  return true;
}

} // namespace prosup::pipeline
