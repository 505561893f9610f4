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
  mesh::UnloadedMesh simulate(const mesh::TetMesh& mesh) override {
    const auto body = make_body(mesh);
    unloading::Unloading unloading(stages_.unloading, *body, stages_.scene.gravity[state_], name_,
                                   log_);
    unloading.set_material(material(*body));
    const unloading::UnloadingResult result = unloading.run();
    log_.line(describe(name_, result));
    n_steps_ = result.n_steps;
    converged_ = result.converged;
    return gather_unloaded(mesh, unloading);
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
