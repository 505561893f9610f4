#include "prosup/core/collective.h"
#include "prosup/core/log.h"
#include "prosup/core/text_file.h"
#include "prosup/image/image_io.h"
#include "prosup/output/outlines.h"
#include "prosup/pipeline/commands.h"
#include "prosup/pipeline/result_run.h"
#include "prosup/prepare/dicom.h"

namespace prosup::pipeline {

namespace fs = std::filesystem;

namespace {

/// Scans to the input of a registration. Rank 0 works.
class PrepareJob {
public:
  PrepareJob(const AllParameters& all, const dealii::ParameterHandler& handler,
             const ResultTarget& output, MPI_Comm world)
      : all_(all), world_(world), run_("prepare", handler, output, world) {}

  bool run() {
    on_every_rank(world_, [&] { all_.scans.require_any(); });
    for (const Position position : both_positions)
      if (!all_.scans.scans[position].empty())
        prepare(position);
    on_root(world_, [&] { write_case(); });
    run_.summary().converged = true;
    return run_.finish();
  }

private:
  void prepare(Position position) {
    const std::string name = name_of(position);
    image::ScalarImage scan;
    prepare::PreparedScan prepared;
    run_.stage("Reading " + name, [&] { on_root(world_, [&] { scan = read(position); }); });
    run_.stage("Segmenting " + name, [&] {
      on_root(world_, [&] {
        prepared = all_.preparation.run(std::move(scan), run_.log());
        for (const std::string& doubt : prepared.confidence.doubts)
          run_.remarks().add(format("In %s, %s", name.c_str(), doubt.c_str()));
      });
    });
    run_.stage("Writing " + name, [&] { on_root(world_, [&] { write(position, prepared); }); });
  }

  image::ScalarImage read(Position position) {
    const fs::path file = all_.scans.scans[position];
    return fs::is_directory(file) ? prepare::read_dicom(file, position, all_.scans.series(position),
                                                        run_.log(), run_.remarks())
                                  : image::read_image(file, run_.remarks());
  }

  void write(Position position, const prepare::PreparedScan& prepared) {
    const std::string name = name_of(position);
    image::write_image(prepared.image, run_.folder() / (name + ".nii.gz"));
    image::write_labels(prepared.labels, run_.folder() / (name + "_labels.nii.gz"));
    image::write_image(prepared.gland, run_.folder() / (name + "_gland.nii.gz"));
    const Labels& labels = all_.registration.labels;
    if (all_.results.pictures)
      output::write_outlines(prepared.image, prepared.labels,
                             {labels.chest, labels.fat(), labels.gland}, name, run_.folder());
    run_.log().line(
        format("  fat %.0f ml, gland %.0f ml", prepared.fat_volume, prepared.gland_volume));
    output::PreparationSummary& summary = run_.summary().preparation[position].emplace();
    summary.contrast = prepare::contrast_names()[std::size_t(prepared.contrast)];
    summary.fat_volume = prepared.fat_volume;
    summary.gland_volume = prepared.gland_volume;
    summary.weak_edge = prepared.confidence.weak_edge;
    summary.separation = prepared.confidence.separation;
  }

  /// The parameters with which the results are registered, or meshed if there is only one.
  void write_case() const {
    const PerPosition<std::string>& scans = all_.scans.scans;
    const Labels& labels = all_.registration.labels;
    std::string text = "# Made by prosup prepare; for prosup register, or for prosup mesh, unload\n"
                       "# and load if one position is given.\n\nsubsection Case\n";
    for (const Position position : both_positions) {
      if (scans[position].empty())
        continue;
      const std::string name = name_of(position);
      const std::string entry = position == Position::prone ? "Prone" : "Supine";
      text += format("  set %s image = %s.nii.gz\n  set %s labels = %s_labels.nii.gz\n",
                     entry.c_str(), name.c_str(), entry.c_str(), name.c_str());
    }
    if (scans.prone.empty())
      text += "  set State = supine\n";
    text += format("end\n\nsubsection Labels\n  set Chest = %u\n  set Tissues = %s\n  set Gland = "
                   "%u\nend\n",
                   labels.chest, joined(labels.tissues).c_str(), labels.gland);
    write_text_file(text, run_.folder() / "case.prm");
  }

  const AllParameters& all_;
  MPI_Comm world_;
  ResultRun run_;
};

} // namespace

bool run_prepare(const AllParameters& parameters, const dealii::ParameterHandler& all,
                 const ResultTarget& output, MPI_Comm world) {
  return PrepareJob(parameters, all, output, world).run();
}

} // namespace prosup::pipeline
