#include "prosup/core/collective.h"
#include "prosup/core/log.h"
#include "prosup/core/text_file.h"
#include "prosup/pipeline/commands.h"
#include "prosup/pipeline/result_run.h"
#include "scan_stage.h"

namespace prosup::pipeline {

namespace {

/// Scans to the input of a registration. Rank 0 works.
class PrepareJob {
public:
  PrepareJob(const AllParameters& all, const dealii::ParameterHandler& handler,
             const ResultTarget& output, MPI_Comm world)
      : all_(all), world_(world), run_("prepare", handler, output, world),
        scans_({all.scans, all.preparation, all.registration.labels, all.results.pictures}, {},
               run_, world) {}

  bool run() {
    on_every_rank(world_, [&] {
      all_.scans.require_any();
      all_.scans.require_no_contradiction();
    });
    for (const Position position : both_positions)
      if (all_.scans.gives(position))
        scans_.run(position);
    differ_ = scans_.contrasts_differ();
    on_root(world_, [&] { write_case(); });
    run_.summary().converged = true;
    return run_.finish();
  }

private:
  /// The parameters with which the results are registered, or meshed if there is only one.
  void write_case() const {
    const Labels& labels = all_.registration.labels;
    std::string text = "# Made by prosup prepare; for prosup register, or for prosup mesh, unload\n"
                       "# and load if one position is given.\n\nsubsection Case\n";
    for (const Position position : both_positions) {
      if (!all_.scans.gives(position))
        continue;
      const std::string name = name_of(position);
      const std::string entry = position == Position::prone ? "Prone" : "Supine";
      text += format("  set %s image = %s.nii.gz\n  set %s labels = %s_labels.nii.gz\n",
                     entry.c_str(), name.c_str(), entry.c_str(), name.c_str());
    }
    if (!all_.scans.gives(Position::prone))
      text += "  set State = supine\n";
    text += format("end\n\nsubsection Labels\n  set Chest = %u\n  set Tissues = %s\n  set Gland = "
                   "%u\n  set Unknown = %u\nend\n",
                   labels.chest, joined(labels.tissues).c_str(), labels.gland, labels.unknown);
    const similarity::SimilarityParameters& similarity = all_.registration.similarity;
    if (differ_ || !similarity.is_automatic())
      text += "\nsubsection Similarity\n  set Metric = " + similarity.make_metric(differ_)->name() +
              "\nend\n";
    write_text_file(text, run_.folder() / "case.prm");
  }

  const AllParameters& all_;
  MPI_Comm world_;
  ResultRun run_;
  ScanStage scans_;
  bool differ_ = false; // the contrasts of the two scans
};

} // namespace

bool run_prepare(const AllParameters& parameters, const dealii::ParameterHandler& all,
                 const ResultTarget& output, MPI_Comm world) {
  return PrepareJob(parameters, all, output, world).run();
}

} // namespace prosup::pipeline
