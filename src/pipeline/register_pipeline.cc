#include "prosup/pipeline/register_pipeline.h"

#include <deal.II/base/mpi.h>

#include <algorithm>

#include "prosup/core/collective.h"
#include "prosup/core/parameters.h"
#include "prosup/core/result_folder.h"
#include "prosup/core/version.h"
#include "prosup/mesh/deformation.h"
#include "prosup/mesh/quality.h"
#include "prosup/output/pictures.h"
#include "prosup/output/vtu.h"
#include "prosup/pipeline/body_building.h"
#include "prosup/pipeline/chest_alignment.h"
#include "prosup/pipeline/result_images.h"

namespace prosup::pipeline {

using namespace dealii;
using similarity::prone;
using similarity::supine;

namespace {

namespace stage {
constexpr const char* read = "Reading images";
constexpr const char* align = "Aligning chests";
constexpr const char* mesh = "Meshing";
constexpr const char* unloading = "Unloading";
constexpr const char* material = "Material update";
constexpr const char* image_forces = "Image forces";
constexpr const char* write = "Writing results";
} // namespace stage

/// The path of the folder that only rank 0 has.
std::filesystem::path shared_path(const ResultFolder* folder, MPI_Comm communicator) {
  return Utilities::MPI::broadcast(communicator,
                                   folder == nullptr ? std::string() : folder->path().string());
}

} // namespace

RegisterPipeline::RegisterPipeline(const Stages& stages, const ParameterHandler& parameters,
                                   MPI_Comm world)
    : stages_(stages), parameters_(parameters), log_(world), ranks_(world),
      timer_(ranks_.world(), log_),
      method_(make_method(stages.scene.method(), stages, ranks_, log_)) {
  summary_.command = "register";
  summary_.metric = stages.similarity.metric;
  summary_.ranks = Utilities::MPI::n_mpi_processes(world);
  summary_.converged = true;
  summary_.steps = 0;
  log_.line(format("prosup %s, deal.II %s, %u rank%s", version(), dealii_version(), summary_.ranks,
                   summary_.ranks == 1 ? "" : "s"));
}

bool RegisterPipeline::run(const std::filesystem::path& output) {
  std::unique_ptr<ResultFolder> folder;
  on_root(ranks_.world(), [&] { folder = std::make_unique<ResultFolder>(output); });

  timer_.run(stage::read, [&] { read(); });
  if (stages_.pre_alignment.wanted())
    timer_.run(stage::align, [&] { align(); });
  timer_.run(stage::mesh, [&] { build(); });
  timer_.run(stage::unloading, [&] { unload(); });
  timer_.run(stage::material, [&] { update_material(); });
  timer_.run(stage::image_forces, [&] { push_with_image_forces(); });
  timer_.run(stage::write, [&] { write(shared_path(folder.get(), ranks_.world())); });

  summary_.peak_memory = peak_memory(ranks_.world());
  on_root(ranks_.world(), [&] {
    summary_.time = {timer_.seconds(stage::mesh), timer_.seconds(stage::unloading),
                     timer_.seconds(stage::material), timer_.seconds(stage::image_forces),
                     timer_.total()};
    output::write_summary(summary_, folder->path() / "summary.json");
    folder->commit();
    log_.line("\n" + timer_.table());
    if (landmarks_.has_landmarks())
      log_.line("\n" + output::error_table(summary_));
    for (const std::string& warning : summary_.warnings)
      log_.line("Warning: " + warning);
    log_.line("\nResults are in " + output.string());
  });
  return summary_.converged;
}

void RegisterPipeline::read() {
  on_root(ranks_.world(), [&] { landmarks_.read(stages_.scene); });
  inputs_ = stages_.inputs.read_pair(stages_.scene, ranks_.world());
  summary_.tre.initial = landmarks_.initial();
}

void RegisterPipeline::align() {
  summary_.alignment = align_chests(stages_.pre_alignment, inputs_, log_, ranks_.world());
}

void RegisterPipeline::build() {
  method_->build(inputs_);
}

void RegisterPipeline::unload() {
  record(method_->unload());
  evaluate(summary_.tre.unloaded);
}

void RegisterPipeline::update_material() {
  const registration::MaterialUpdateResult result = method_->update_material(observer());
  *summary_.steps += result.n_steps;
  summary_.converged = summary_.converged && result.converged;
  const registration::MechanicalProperties& found = method_->properties();
  summary_.shear_modulus = found.tissue.shear_modulus;
  summary_.poisson_ratio = found.tissue.poisson_ratio;
  summary_.gland_ratio = found.tissue.gland_ratio;
  if (found.chest_stiffness > 0.)
    summary_.chest_stiffness = found.chest_stiffness;
  summary_.lambda =
      mechanics::lame_parameters(found.tissue.shear_modulus, found.tissue.poisson_ratio).lambda;
  evaluate(summary_.tre.material);
}

void RegisterPipeline::push_with_image_forces() {
  const registration::ImageForceResult result = method_->push_with_image_forces(observer());
  *summary_.steps += result.n_steps;
  summary_.converged = summary_.converged && result.converged;
  evaluate(summary_.tre.image_forces);
}

registration::Observer RegisterPipeline::observer() {
  return [this](const registration::SimilarityRecord& record) {
    const registration::MechanicalProperties& properties = method_->properties();
    output::ConvergenceEntry& entry = convergence_.emplace_back();
    entry = {record.stage,
             record.level,
             record.iteration,
             timer_.total(),
             record.value,
             properties.tissue.shear_modulus,
             properties.tissue.poisson_ratio,
             properties.tissue.gland_ratio,
             properties.chest_stiffness,
             record.force_weight,
             {}};
    if (!stages_.scene.landmarks.empty())
      timer_.set_aside([&] { evaluate(entry.error); });
    summary_.similarity.push_back({record.stage, record.level, record.iteration, record.value});
  };
}

void RegisterPipeline::evaluate(std::optional<evaluation::ErrorStatistics>& error) {
  unloaded_ = method_->unloaded();
  on_root(ranks_.world(), [&] { error = landmarks_.evaluate(unloaded_); });
}

void RegisterPipeline::record(const std::array<settling::SettlingResult, 2>& results) {
  for (const auto& result : results) {
    *summary_.steps += result.n_steps;
    summary_.converged = summary_.converged && result.converged;
  }
  log_.line(describe("prone", results[prone]));
  log_.line(describe("supine", results[supine]));
}

void RegisterPipeline::add_mesh_summaries() {
  for (const auto state : {prone, supine}) {
    const mesh::MeshQuality quality = mesh::measure_quality(unloaded_[state].mesh);
    const mesh::JacobianRange jacobian = mesh::jacobian_range(unloaded_[state]);
    (state == prone ? summary_.prone : summary_.supine) = {
        quality.n_cells, quality.n_nodes, quality.min_quality, jacobian.min, jacobian.max};
  }
}

void RegisterPipeline::write(const std::filesystem::path& folder) {
  on_root(ranks_.world(), [&] {
    add_mesh_summaries();
    summary_.inverse_consistency = evaluation::inverse_consistency(
        unloaded_[prone].mesh.points, evaluation::PointMapper(unloaded_[prone]),
        evaluation::PointMapper(unloaded_[supine]));
    if (!summary_.converged)
      summary_.warnings.push_back("a simulation did not settle within 'Unloading/Maximum steps'");
    output::write_mesh(unloaded_[prone], folder, "prone");
    output::write_mesh(unloaded_[supine], folder, "supine");
    landmarks_.write(folder / "landmarks.csv");
    output::write_convergence(convergence_, folder / "convergence.csv");
    if (stages_.results.pictures)
      output::write_convergence_picture(convergence_, folder / "convergence.svg");
    write_parameters(parameters_, folder / "used.prm");
  });
  const std::array<image::ScalarImage, 2> unloaded_images =
      write_images(unloaded_, inputs_.originals, stages_.results, folder, ranks_);
  on_root(ranks_.world(), [&] {
    const auto& [prone_image, supine_image] = inputs_.originals;
    if (stages_.results.pictures)
      output::write_registration_slices({prone_image.image, supine_image.image, prone_image.breast,
                                         supine_image.breast, unloaded_images[prone],
                                         unloaded_images[supine]},
                                        folder);
  });
}

} // namespace prosup::pipeline
