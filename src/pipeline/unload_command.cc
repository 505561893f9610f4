#include "finite_differences.h"
#include "prosup/image/broadcast.h"
#include "prosup/mesh/deformation.h"
#include "prosup/output/pictures.h"
#include "single_state_job.h"

namespace prosup::pipeline {

namespace {

/// One state to its unloaded configuration.
class UnloadJob : public SingleStateJob {
public:
  UnloadJob(const Stages& stages, MPI_Comm world)
      : SingleStateJob(stages, world, "unload", "Unloading") {}

protected:
  mesh::UnloadedMesh simulate(mesh::TetMesh mesh) override {
    const auto body = make_body(stages_, mesh, world_);
    const mechanics::NodeVector unloaded = equilibrium(*body, Direction::unload);
    return {mesh, mesh::at_nodes(mesh, body->gather_at_cells(unloaded))};
  }

  std::optional<evaluation::ErrorStatistics> error() const override {
    return landmarks_.evaluate(state_, mesh_);
  }

  void write_images(const std::filesystem::path& folder) const override {
    const image::VectorImage field =
        write_field(mesh_, folder / ("unloaded_to_" + name_ + ".nrrd"));
    const auto unloaded = write_warped(field, folder / (name_ + "_unloaded.nii.gz"));
    if (unloaded && stages_.results.pictures)
      output::write_unloading_slices(original_->image, original_->breast, *unloaded, folder);
  }
};

/// The same by finite differences, which need no mesh.
class GridUnloadJob : public UnloadJob {
public:
  using UnloadJob::UnloadJob;

private:
  mesh::TetMesh make_mesh() override { return {}; }

  mesh::UnloadedMesh simulate(mesh::TetMesh) override {
    image::broadcast(labels_, world_);
    const unsigned chest_label = stages_.labels.chest;
    const fdm::FdmBody body{
        labels_,
        chest_label,
        registration::grid_material(stages_.material, stages_.material.initial(), labels_,
                                    chest_label),
        acceleration(stages_, stages_.scene.gravity[state_]),
        {chest_contact(stages_), stages_.supports.chest_stiffness(stages_.scene.chest())},
        stages_.unloading.density};
    fdm::FdmUnloading unloading(stages_.fdm, body, world_, name_, log_);
    const settling::SettlingResult result = unloading.run();
    log_.line(describe(name_, result));
    n_steps_ = result.n_steps;
    converged_ = result.converged;
    return mesh_of_grid(stages_, unloading.displacement(), labels_);
  }
};

} // namespace

bool run_unload(const Stages& stages, const dealii::ParameterHandler& parameters,
                const std::filesystem::path& output, MPI_Comm world) {
  if (stages.scene.method() == "fdm")
    return GridUnloadJob(stages, world).run(parameters, output);
  return UnloadJob(stages, world).run(parameters, output);
}

} // namespace prosup::pipeline
