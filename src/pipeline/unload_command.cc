#include <deal.II/base/mpi.h>

#include "prosup/core/collective.h"
#include "prosup/core/parameters.h"
#include "prosup/core/result_folder.h"
#include "prosup/core/version.h"
#include "prosup/evaluation/point_mapper.h"
#include "prosup/image/filters.h"
#include "prosup/image/image_io.h"
#include "prosup/mesh/deformation.h"
#include "prosup/mesh/distributed.h"
#include "prosup/mesh/quality.h"
#include "prosup/output/displacement_fields.h"
#include "prosup/output/pictures.h"
#include "prosup/output/summary.h"
#include "prosup/output/vtu.h"
#include "prosup/pipeline/body_building.h"
#include "prosup/pipeline/commands.h"
#include "prosup/pipeline/stage_timer.h"
#include "prosup/pipeline/unloaded_grid.h"

namespace prosup::pipeline {

using similarity::state_names;
using unloading::UnloadingResult;

namespace {

/// One state to its unloaded configuration, on all ranks of a communicator.
class UnloadJob {
public:
  UnloadJob(const Stages& stages, MPI_Comm world)
      : stages_(stages), state_(stages.scene.state()), world_(world), log_(world),
        timer_(world, log_) {}

  bool run(const dealii::ParameterHandler& parameters, const std::filesystem::path& output) {
    std::unique_ptr<ResultFolder> folder;
    on_root(world_, [&] { folder = std::make_unique<ResultFolder>(output); });
    timer_.run("Reading", [&] { read(); });
    timer_.run("Meshing", [&] { build(); });
    timer_.run("Unloading", [&] { unload(); });
    timer_.run("Writing results",
               [&] { on_root(world_, [&] { write(parameters, folder->path()); }); });
    const double memory = peak_memory(world_);
    on_root(world_, [&] {
      output::write_summary(summary(memory), folder->path() / "summary.json");
      folder->commit();
      log_.line("\n" + timer_.table() + "\n\nResults are in " + output.string());
    });
    return result_.converged;
  }

private:
  void read() {
    on_root(world_, [&] {
      labels_ = stages_.inputs.read_labels(stages_.scene, state_);
      original_ = stages_.inputs.read_image(stages_.scene, state_);
    });
  }

  void build() {
    on_root(world_, [&] { mesh_.mesh = stages_.mesher.run(labels_); });
    body_ = std::make_unique<mechanics::Body>(*mesh::make_distributed(mesh_.mesh, world_));
  }

  void unload() {
    unloading::Unloading unloading(stages_.unloading, *body_, stages_.scene.gravity[state_],
                                   state_names[state_], log_);
    const double shear_modulus = stages_.material.initial_shear_modulus();
    unloading.set_material(stages_.material.parameters_of(body_->material_ids(), shear_modulus));
    result_ = unloading.run();
    log_.line(describe(state_names[state_], result_));
    mesh_ = gather_unloaded(mesh_.mesh, unloading);
  }

  void write(const dealii::ParameterHandler& parameters,
             const std::filesystem::path& folder) const {
    output::write_mesh(mesh_, folder, state_names[state_]);
    write_parameters(parameters, folder / "used.prm");
    const image::VoxelGrid grid =
        unloaded_grid({&mesh_}, stages_.results.voxel_edge, stages_.results.margin);
    const image::VectorImage field =
        output::unloaded_to_loaded(grid, mesh_, evaluation::PointMapper(mesh_));
    const std::string name = state_names[state_];
    image::write_displacement(field, folder / ("unloaded_to_" + name + ".nrrd"));
    if (!original_)
      return;
    const image::ScalarImage unloaded = image::warp(original_->image, field);
    image::write_image(unloaded, folder / (name + "_unloaded.nii.gz"));
    if (stages_.results.pictures)
      output::write_unloading_slices(original_->image, original_->breast, unloaded, folder);
  }

  output::Summary summary(double memory) const {
    const mesh::MeshQuality quality = mesh::measure_quality(mesh_.mesh);
    output::Summary summary;
    summary.command = "unload";
    summary.ranks = dealii::Utilities::MPI::n_mpi_processes(world_);
    (state_ == 0 ? summary.prone : summary.supine) = output::StateSummary{
        quality.n_cells, quality.n_nodes, quality.min_quality, mesh::min_jacobian(mesh_)};
    summary.steps = result_.n_steps;
    summary.shear_modulus = stages_.material.initial_shear_modulus();
    summary.time.mesh = timer_.seconds("Meshing");
    summary.time.unloading = timer_.seconds("Unloading");
    summary.time.total = timer_.total();
    summary.peak_memory = memory;
    summary.converged = result_.converged;
    return summary;
  }

  const Stages& stages_;
  const unsigned state_;
  MPI_Comm world_;
  const Log log_;
  StageTimer timer_;
  image::LabelImage labels_;
  std::optional<OriginalImage> original_;
  mesh::UnloadedMesh mesh_;
  std::unique_ptr<mechanics::Body> body_;
  UnloadingResult result_;
};

} // namespace

bool run_unload(const Stages& stages, const dealii::ParameterHandler& parameters,
                const std::filesystem::path& output, MPI_Comm world) {
  return UnloadJob(stages, world).run(parameters, output);
}

} // namespace prosup::pipeline
