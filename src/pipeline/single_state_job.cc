#include "single_state_job.h"

#include <utility>

#include "prosup/core/collective.h"
#include "prosup/evaluation/point_mapper.h"
#include "prosup/image/broadcast.h"
#include "prosup/image/image_io.h"
#include "prosup/output/displacement_fields.h"
#include "prosup/output/vtu.h"
#include "prosup/pipeline/descriptions.h"
#include "prosup/pipeline/result_images.h"
#include "prosup/pipeline/unloaded_grid.h"
#include "state_hdf5.h"

namespace prosup::pipeline {

namespace fs = std::filesystem;

namespace {

constexpr const char* meshing = "Meshing";

} // namespace

SingleStateJob::SingleStateJob(const AllParameters& parameters, const dealii::ParameterHandler& all,
                               const ResultTarget& output, MPI_Comm world,
                               const std::string& command, std::string simulation)
    : parameters_(parameters), position_(parameters.case_files.position()),
      name_(name_of(position_)), world_(world), simulation_(std::move(simulation)),
      run_(command, all, output, world),
      checkpoints_(command, parameters.checkpoint, all, output.folder, world, run_.log(),
                   run_.remarks()) {
  run_.keep_log_of_failure(parameters.checkpoint.folder_for(output.folder) /
                           Checkpoints::log_of_failure);
  if (parameters.checkpoint.restart && parameters.model().simulation.method != "fe")
    throw Error("Finite differences leave no checkpoints; run without --restart.");
  scene_.chest_label = parameters.registration.labels.chest;
  scene_.gland_label = parameters.registration.labels.gland;
  scene_.unknown_label = parameters.registration.labels.unknown;
}

bool SingleStateJob::run() {
  run_.stage("Reading", [&] { on_root(world_, [&] { read(); }); });
  restart();
  on_root(world_, [&] { check(); });
  if (!breast_) {
    run_.stage(meshing, [&] { build(); });
    keep(false);
  }
  if (!is_done_) {
    run_.stage(simulation_, [&] { simulate(); });
    keep(true);
  }
  run_.stage("Writing results", [&] { write(); });
  run_.summary().time.mesh = run_.seconds(meshing);
  run_.summary().time.unloading = run_.seconds(simulation_);
  const bool settled = run_.finish(report());
  checkpoints_.remove();
  return settled;
}

void SingleStateJob::restart() {
  const auto checkpoint = checkpoints_.restart();
  if (!checkpoint)
    return;
  registration::BreastState state = read_breast_state(*checkpoint, name_);
  given_mesh_ = std::make_unique<GivenMesh>(state.mesh);
  build();
  breast_->elements()->resume(state);
  is_done_ = checkpoint->number("run/is_done") > 0.;
  steps_before_ = static_cast<unsigned>(checkpoint->number("run/steps"));
  if (!is_done_)
    return;
  run_.summary().steps = steps_before_;
  run_.summary().converged = checkpoint->number("run/converged") > 0.;
  mesh_ = breast_->mesh();
}

unsigned SingleStateJob::steps_left() const {
  if (steps_before_ == 0)
    return 0;
  const unsigned all = parameters_.model().unloading.max_steps;
  return all > steps_before_ ? all - steps_before_ : 1;
}

/// Newton's method leaves the breast as it is, so that only its mesh is kept.
void SingleStateJob::keep(bool is_done) {
  registration::ElementBreast* const elements = breast_->elements();
  if (elements == nullptr || (is_done && !parameters_.single_state.is_explicit()))
    return;
  checkpoints_.keep([&](output::Hdf5Writer& file) {
    write_state(file, name_, elements->state(), world_);
    file.number("run/is_done", is_done ? 1. : 0.);
    file.number("run/steps", static_cast<double>(run_.summary().steps.value_or(0)));
    file.number("run/converged", run_.summary().converged ? 1. : 0.);
  });
}

void SingleStateJob::read() {
  const CaseParameters& given = parameters_.case_files;
  const registration::InputReader& images = parameters_.registration.images;
  landmarks_.read(given, run_.remarks());
  given.require_labels(position_);
  registration::SingleInput breast = images.read_breast(given.files(), position_, run_.remarks());
  scene_.labels[position_] = std::move(breast.labels);
  original_ = std::move(breast.original);
  if (!given.files().labels[other(position_)].empty() &&
      parameters_.model().supports.need_other_labels())
    scene_.labels[other(position_)] =
        images.read_breast(given.files(), other(position_), run_.remarks()).labels;
}

void SingleStateJob::check() {
  if (scene_.labels[position_].values.empty())
    return;
  const registration::SceneCheck& checks = parameters_.registration.checks;
  const dealii::Tensor<1, 3>& gravity = parameters_.case_files.files().gravity[position_];
  checks.check_one(scene_.labels[position_], position_, gravity).tell(run_.remarks());
}

void SingleStateJob::build() {
  for (const Position position : both_positions)
    image::broadcast(scene_.labels[position], world_);
  const registration::CaseFiles& files = parameters_.case_files.files();
  breast_ = registration::make_breast(parameters_.model(),
                                      {position_, scene_, files.gravity[position_], files.chest,
                                       given_mesh_ ? given_mesh_.get() : mesh_source(), run_.log()},
                                      world_);
}

/// A breast that does not settle leaves its last good state, for inspection.
void SingleStateJob::simulate_explicitly() {
  output::Summary& summary = run_.summary();
  summary.converged = false;
  try {
    const settling::SettlingResult result = settle(*breast_);
    run_.log().line(describe(name_, result));
    for (const std::string& remark : result.remarks)
      run_.remarks().add(remark);
    summary.steps = steps_before_ + result.n_steps;
    summary.converged = result.converged;
  } catch (const DivergenceError& error) {
    run_.remarks().add(error.what());
  }
  mesh_ = breast_->mesh();
}

void SingleStateJob::simulate() {
  output::Summary& summary = run_.summary();
  registration::ElementBreast* elements = breast_->elements();
  if (parameters_.single_state.is_explicit() || elements == nullptr) {
    if (elements != nullptr)
      elements->unloading().set_keeper([&](unsigned n_steps) {
        summary.steps = steps_before_ + n_steps;
        keep(false);
      });
    simulate_explicitly();
  } else {
    const unloading::UnloadingParameters& load = parameters_.model().unloading;
    const dealii::Tensor<1, 3>& direction = parameters_.case_files.files().gravity[position_];
    auto [result, mesh] =
        solve(*elements, {parameters_.quasi_static, parameters_.model().supports.contact_stiffness,
                          load.density * load.gravity / direction.norm() * direction, run_.log()});
    run_.log().line(describe(name_, result));
    summary.steps = result.n_newton_steps;
    summary.converged = result.converged;
    mesh_ = std::move(mesh);
  }
}

void SingleStateJob::write() {
  on_root(world_, [&] {
    output::Summary& summary = run_.summary();
    summary.breasts[position_] = output::summarize(mesh_);
    summary.tre.unloaded = error();
    summary.shear_modulus = parameters_.model().material.initial().shear_modulus;
    output::write_mesh(mesh_, run_.folder(), name_);
    write_images(run_.folder());
  });
}

std::string SingleStateJob::report() const {
  const auto error = this->error();
  return error ? format("Landmarks: %.2f mm mean, %.2f mm max from their true unloaded positions",
                        error->mean, error->max)
               : "";
}

image::VectorImage SingleStateJob::write_field(const mesh::UnloadedMesh& mesh,
                                               const fs::path& file) const {
  const image::VoxelGrid grid =
      unloaded_grid({&mesh}, parameters_.results.voxel_edge, parameters_.results.margin);
  const unsigned chest_label = parameters_.registration.labels.chest;
  const image::LabelImage& labels = scene_.labels[position_];
  image::VectorImage field =
      output::unloaded_to_loaded(grid, mesh, evaluation::PointMapper(mesh),
                                 {{}, output::voxels_with(labels, chest_label)})
          .displacement;
  image::write_displacement(field, file);
  return field;
}

std::optional<image::ScalarImage> SingleStateJob::write_warped(const image::VectorImage& field,
                                                               const fs::path& file) const {
  if (!original_)
    return {};
  return pipeline::write_warped(original_->image, field, file);
}

} // namespace prosup::pipeline
