#include "prosup/registration/scene_check.h"

#include <algorithm>

#include "prosup/core/error.h"
#include "prosup/core/log.h"
#include "scene_findings.h"

namespace prosup::registration {

using namespace dealii;

namespace {

constexpr double voxel_edge = 2.5; // mm; shorter changes no finding and takes longer

void append(Findings& all, Findings more) {
  all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

void put_errors_first(Findings& findings) {
  std::stable_partition(findings.begin(), findings.end(), [](const Finding& finding) {
    return finding.severity == Finding::Severity::error;
  });
}

} // namespace

bool has_error(const Findings& findings) {
  return std::any_of(findings.begin(), findings.end(), [](const Finding& finding) {
    return finding.severity == Finding::Severity::error;
  });
}

std::size_t SceneReport::n_errors() const {
  return std::size_t(std::count_if(findings.begin(), findings.end(), [](const Finding& finding) {
    return finding.severity == Finding::Severity::error;
  }));
}

void SceneReport::tell(Remarks& remarks) const {
  for (const Finding& finding : findings)
    remarks.add(finding.text);
}

SceneCheck::SceneCheck(const Labels& labels) : ParameterAcceptor("Checks"), labels_(labels) {}

void SceneCheck::declare_parameters(ParameterHandler& prm) {
  prm.add_parameter("Errors stop the run", stops_,
                    "Whether an error that the check of the scene finds before the first "
                    "simulation, such as prone and supine exchanged, ends the run. If false, it "
                    "becomes a warning.");
}

SceneReport SceneCheck::check_pair(const Inputs& inputs, const PerPosition<Tensor<1, 3>>& gravity,
                                   bool needs_same_contrast) const {
  SceneReport report;
  PerPosition<BreastMeasures> breasts;
  for (const Position position : both_positions) {
    breasts[position] = measure(inputs.scene.labels[position], labels_, voxel_edge);
    append(report.findings, findings_of(breasts[position], position, labels_));
  }
  const PairMeasures pair = compare(breasts, inputs, gravity, labels_, voxel_edge);
  report.measures = table_of(breasts, gravity) + table_of(pair);
  const bool labels_are_right = !has_error(report.findings);
  const bool is_aligned = inputs.alignment.translation.norm() > 0.;
  const SceneOptions options{needs_same_contrast && labels_are_right, is_aligned};
  const Findings images = image_findings_of(pair, options);
  // What two copies of one image differ by, or breasts whose labels are wrong, says nothing.
  if (labels_are_right && !pair.same_labels)
    append(report.findings, findings_of(breasts, pair, gravity, options));
  append(report.findings, images);
  put_errors_first(report.findings);
  return report;
}

SceneReport SceneCheck::check_one(const image::LabelImage& labels, Position position,
                                  const std::optional<Tensor<1, 3>>& gravity) const {
  const BreastMeasures breast = measure(labels, labels_, voxel_edge);
  SceneReport report;
  report.findings = findings_of(breast, position, labels_);
  if (gravity && !has_error(report.findings))
    append(report.findings, gravity_findings_of(breast, position, *gravity));
  put_errors_first(report.findings);
  return report;
}

void SceneCheck::accept(const SceneReport& report, Remarks& remarks) const {
  const std::size_t n_errors = report.n_errors();
  if (stops_ && n_errors > 0) {
    std::string text = report.findings.front().text;
    text.pop_back(); // the full stop
    const std::size_t n_more = report.findings.size() - 1;
    if (n_more > 0)
      text += format(" (%zu more finding%s: see prosup check)", n_more, n_more == 1 ? "" : "s");
    throw Error(text + "; 'Checks/Errors stop the run = false' goes on all the same.");
  }
  report.tell(remarks);
}

} // namespace prosup::registration
