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

private:
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

} // namespace

bool run_unload(const Stages& stages, const dealii::ParameterHandler& parameters,
                const std::filesystem::path& output, MPI_Comm world) {
  return UnloadJob(stages, world).run(parameters, output);
}

} // namespace prosup::pipeline
