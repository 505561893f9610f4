#include "prosup/pipeline/register_pipeline.h"

#include <deal.II/base/numbers.h>

#include "checkpoints.h"
#include "mesh_figures.h"
#include "prosup/core/collective.h"
#include "prosup/output/pictures.h"
#include "prosup/output/registration_file.h"
#include "prosup/output/vtu.h"
#include "prosup/pipeline/commands.h"
#include "prosup/pipeline/descriptions.h"
#include "prosup/pipeline/result_images.h"
#include "prosup/registration/verdict.h"
#include "result_report.h"
#include "scan_stage.h"

namespace prosup::pipeline {

using namespace dealii;
using registration::MechanicalProperties;

namespace {

namespace stage {
constexpr const char* read = "Reading images";
constexpr const char* align = "Aligning chests";
constexpr const char* check = "Checking the scene";
constexpr const char* mesh = "Meshing";
constexpr const char* unloading = "Unloading";
constexpr const char* material = "Material update";
constexpr const char* image_forces = "Image forces";
constexpr const char* uncertainty = "Uncertainty";
constexpr const char* write = "Writing results";
} // namespace stage

output::AlignmentSummary summary_of(const registration::Alignment& alignment) {
  output::AlignmentSummary summary;
  summary.method = alignment.method;
  const Tensor<1, 3> rotation = alignment.transform.rotation_vector();
  for (unsigned d = 0; d < 3; ++d) {
    summary.translation[d] = alignment.transform.translation[d];
    summary.rotation_degrees[d] = 180. / numbers::PI * rotation[d];
  }
  summary.surface_before = alignment.surface.distance_before;
  summary.surface_after = alignment.surface.distance_after;
  if (alignment.intensities)
    summary.information = {alignment.intensities->information_before,
                           alignment.intensities->information_after};
  return summary;
}

std::map<std::string, double> named(const MechanicalProperties& properties) {
  return {{"shear_modulus", properties.tissue.shear_modulus},
          {"poisson_ratio", properties.tissue.poisson_ratio},
          {"gland_ratio", properties.tissue.gland_ratio},
          {"skin_stiffness", properties.tissue.skin_stiffness},
          {"chest_stiffness", properties.chest_stiffness},
          {"lateral_chest_ratio", properties.lateral_chest_ratio},
          {"prone_cut_plane_stiffness", properties.cut_plane_stiffness.prone},
          {"supine_cut_plane_stiffness", properties.cut_plane_stiffness.supine},
          {"tilt_left", properties.tilt.degrees()[0]},
          {"tilt_superior", properties.tilt.degrees()[1]}};
}

} // namespace

RegisterPipeline::RegisterPipeline(const CaseParameters& case_files,
                                   const ScanStageParameters& scans,
                                   const registration::RegistrationParameters& parameters,
                                   const ResultParameters& results,
                                   const CheckpointParameters& checkpoint,
                                   const ParameterHandler& all, const ResultTarget& output,
                                   MPI_Comm world)
    : case_files_(case_files), scans_(scans.scans), checks_(parameters.checks),
      similarity_(parameters.similarity), results_(results),
      aligns_(parameters.pre_alignment.wanted()), run_("register", all, output, world),
      registration_(parameters, world, run_.log()),
      preparation_(std::make_unique<ScanStage>(scans, "prepared", run_, world)) {
  run_.summary().metric = similarity_.make_metric()->name();
  run_.summary().steps = 0;
  registration_.set_observer(
      [this](const registration::SimilarityRecord& record) { observe(record); });
  run_.keep_log_of_failure(checkpoint.folder_for(output.folder) / Checkpoints::log_of_failure);
  if (registration_.has_state())
    checkpoints_ = std::make_unique<Checkpoints>("register", checkpoint, all, output.folder, world,
                                                 run_.log(), run_.remarks());
  else if (checkpoint.restart)
    throw Error("Finite differences leave no checkpoints; run without --restart.");
  registration_.set_keeper([this] { keep(); });
}

RegisterPipeline::~RegisterPipeline() = default;

Outcome RegisterPipeline::run() {
  using registration::Stage;
  prepare_scans();
  run_.stage(stage::read, [&] { read(); });
  restart();
  if (aligns_ && registration_.stage() < Stage::built)
    run_.stage(stage::align, [&] { align(); });
  run_.stage(stage::check, [&] { check(); });
  auto& time = run_.summary().time;
  stage(stage::mesh, Stage::built, time.mesh, [&] { registration_.build(); });
  stage(stage::unloading, Stage::unloaded, time.unloading, [&] { unload(); });
  stage(stage::material, Stage::properties_matched, time.material, [&] { match_properties(); });
  stage(stage::image_forces, Stage::images_matched, time.image_forces, [&] { match_images(); });
  run_.stage(stage::uncertainty, [&] { covariances_ = registration_.covariances(); });
  run_.stage(stage::write, [&] { write(); });
  const std::string errors = output::error_table(run_.summary());
  run_.finish(errors + (errors.empty() ? "" : "\n") + output::verdict_text(run_.summary()), [&] {
    write_result_report(run_.folder(), results_.pictures
                                           ? report_images(registration_.inputs().originals)
                                           : std::optional<output::ReportImages>());
  });
  if (checkpoints_)
    checkpoints_->remove();
  if (outcome_ == Outcome::failed) // known on rank 0
    run_.log().warning("The verdict is that the registration failed; the results say why.");
  return dealii::Utilities::MPI::broadcast(registration_.ranks().world(), outcome_);
}

void RegisterPipeline::prepare_scans() {
  on_every_rank(registration_.ranks().world(), [&] {
    scans_.require_no_contradiction(case_files_.files());
    for (const Position position : both_positions)
      if (!scans_.gives(position))
        case_files_.require(position);
  });
  for (const Position position : both_positions)
    if (scans_.gives(position))
      preparation_->run(position);
  quality_.scene_findings = preparation_->doubts();
  if (!similarity_.is_automatic() || !preparation_->contrasts_differ())
    return;
  const auto metric = similarity_.make_metric(true);
  run_.summary().metric = metric->name();
  run_.log().line("The scans have different contrasts: they are compared by " + metric->name());
  registration_.set_metric(metric);
}

void RegisterPipeline::read() {
  on_root(registration_.ranks().world(), [&] { landmarks_.read(case_files_, run_.remarks()); });
  registration::CaseFiles files = case_files_.files();
  for (const Position position : both_positions)
    if (scans_.gives(position)) {
      files.images[position] = preparation_->image(position).string();
      files.labels[position] = preparation_->labels(position).string();
    }
  registration_.read(files, run_.remarks());
  on_root(registration_.ranks().world(), [&] {
    for (const Position position : both_positions)
      landmarks_.check_places(position, registration_.inputs().originals[position].breast,
                              run_.remarks());
  });
  run_.summary().tre.initial = landmarks_.initial();
}

void RegisterPipeline::align() {
  registration_.align();
  if (registration_.alignment())
    run_.summary().alignment = summary_of(*registration_.alignment());
}

void RegisterPipeline::check() {
  const registration::SceneReport report = registration_.check();
  on_root(registration_.ranks().world(), [&] { checks_.accept(report, run_.remarks()); });
  for (const registration::Finding& finding : report.findings)
    quality_.scene_findings.push_back(finding.text);
}

void RegisterPipeline::unload() {
  const auto results = registration_.unload();
  for (const Position position : both_positions) {
    note(results[position].n_steps);
    run_.log().line(describe(name_of(position), results[position]));
    for (const std::string& remark : results[position].remarks)
      run_.remarks().add(remark);
  }
  quality_.unloaded = registration_.agreement(false);
  evaluate(run_.summary().tre.unloaded);
}

void RegisterPipeline::match_properties() {
  const registration::MaterialUpdateResult found = registration_.match_properties();
  note(found.n_steps);
  quality_.at_bound = found.at_bound;
  note_properties();
  quality_.material = registration_.agreement(false);
  evaluate(run_.summary().tre.material);
}

void RegisterPipeline::match_images() {
  note(registration_.match_images().n_steps);
  quality_.image_forces = registration_.agreement();
  evaluate(run_.summary().tre.image_forces);
}

void RegisterPipeline::note(unsigned n_steps) {
  *run_.summary().steps += n_steps;
}

void RegisterPipeline::note_properties() {
  const MechanicalProperties& found = registration_.properties();
  output::Summary& summary = run_.summary();
  summary.shear_modulus = found.tissue.shear_modulus;
  summary.poisson_ratio = found.tissue.poisson_ratio;
  summary.gland_ratio = found.tissue.gland_ratio;
  if (found.tissue.skin_stiffness > 0.)
    summary.skin_stiffness = found.tissue.skin_stiffness;
  if (found.chest_stiffness > 0.) {
    summary.chest_stiffness = found.chest_stiffness;
    summary.lateral_chest_ratio = found.lateral_chest_ratio;
  }
  if (found.cut_plane_stiffness.prone > 0.)
    summary.cut_plane_stiffness = found.cut_plane_stiffness;
  summary.supine_tilt = found.tilt.degrees();
  summary.lambda =
      mechanics::lame_parameters(found.tissue.shear_modulus, found.tissue.poisson_ratio).lambda;
}

void RegisterPipeline::observe(const registration::SimilarityRecord& record) {
  const MechanicalProperties& properties = registration_.properties();
  output::ConvergenceEntry& entry = convergence_.emplace_back();
  entry.stage = record.stage;
  entry.level_mm = record.level;
  entry.iteration = record.iteration;
  entry.seconds = run_.seconds();
  entry.similarity = record.value;
  entry.shear_modulus = properties.tissue.shear_modulus;
  entry.poisson_ratio = properties.tissue.poisson_ratio;
  entry.gland_ratio = properties.tissue.gland_ratio;
  entry.chest_stiffness = properties.chest_stiffness;
  entry.force_weight = record.force_weight;
  if (!case_files_.landmarks().empty())
    run_.set_aside([&] { evaluate(entry.error); });
  run_.summary().similarity.push_back({record.stage, record.level, record.iteration, record.value});
}

void RegisterPipeline::evaluate(std::optional<evaluation::ErrorStatistics>& error) {
  found_ = registration_.result();
  on_root(registration_.ranks().world(), [&] { error = landmarks_.evaluate(found_.meshes); });
}

void RegisterPipeline::judge() {
  output::Summary& summary = run_.summary();
  quality_.converged = found_.converged;
  quality_.properties = found_.properties;
  quality_.chest = registration::measure_chest_misfit(registration_.inputs().scene);
  quality_.same_contrast = registration_.compares_same_contrast();
  summary.inverse_consistency = measure_meshes(found_, case_files_.files().gravity,
                                               registration_.inputs().alignment, quality_);
  const registration::Verdict verdict = registration::judge(quality_);
  outcome_ = verdict.grade == registration::Grade::failed ? Outcome::failed : Outcome::success;
  summary.quality = {name_of(verdict.grade), verdict.reasons, registration::figures_of(quality_)};
}

void RegisterPipeline::write_on_root() {
  const std::filesystem::path& folder = run_.folder();
  output::Summary& summary = run_.summary();
  for (const Position position : both_positions) {
    summary.breasts[position] = output::summarize(found_.meshes[position]);
    output::write_mesh(found_.meshes[position], folder, name_of(position));
  }
  output::write_registration(found_.meshes, named(found_.properties), folder, covariances_,
                             registration_.inputs().alignment);
  if (!covariances_.prone.empty())
    landmarks_.add_error_bars(found_.meshes, covariances_);
  judge();
  landmarks_.write(folder / "landmarks.csv");
  output::write_convergence(convergence_, folder / "convergence.csv");
  if (results_.pictures)
    output::write_convergence_picture(convergence_, folder / "convergence.svg");
}

void RegisterPipeline::write() {
  run_.summary().converged = found_.converged;
  const MPI_Comm world = registration_.ranks().world();
  on_root(world, [&] { write_on_root(); });
  const auto& originals = registration_.inputs().originals;
  const PerPosition<image::ScalarImage> unloaded = write_images(
      found_.meshes, registration_.inputs(), results_, run_.folder(), registration_.ranks());
  if (!covariances_.prone.empty()) // on rank 0
    write_radius_image(found_.meshes, covariances_, results_, run_.folder());
  if (results_.pictures)
    on_root(world, [&] {
      output::write_registration_slices({originals.prone.image, originals.supine.image,
                                         originals.prone.breast, originals.supine.breast,
                                         unloaded.prone, unloaded.supine},
                                        run_.folder());
    });
}

Outcome run_register(const AllParameters& parameters, const ParameterHandler& all,
                     const ResultTarget& output, MPI_Comm world) {
  return RegisterPipeline(parameters.case_files,
                          {parameters.scans, parameters.preparation, parameters.registration.labels,
                           parameters.results.pictures},
                          parameters.registration, parameters.results, parameters.checkpoint, all,
                          output, world)
      .run();
}

} // namespace prosup::pipeline
