#include "prosup/output/pictures.h"
#include "prosup/pipeline/commands.h"
#include "single_state_job.h"

namespace prosup::pipeline {

namespace {

/// One breast to its unloaded configuration.
class UnloadJob : public SingleStateJob {
public:
  UnloadJob(const AllParameters& parameters, const dealii::ParameterHandler& all,
            const ResultTarget& output, MPI_Comm world)
      : SingleStateJob(parameters, all, output, world, "unload", "Unloading") {}

private:
  settling::SettlingResult settle(registration::Breast& breast) override {
    return breast.unload(steps_left());
  }
  registration::QuasiStaticSolution solve(registration::ElementBreast& breast,
                                          const registration::QuasiStaticInput& input) override {
    return unload_quasi_statically(breast, input);
  }

  std::optional<evaluation::ErrorStatistics> error() const override {
    return landmarks_.has_landmarks() ? landmarks_.evaluate(position_, mesh_) : std::nullopt;
  }

  void write_images(const std::filesystem::path& folder) const override {
    const image::VectorImage field =
        write_field(mesh_, folder / ("unloaded_to_" + name_ + ".nrrd"));
    const auto unloaded = write_warped(field, folder / (name_ + "_unloaded.nii.gz"));
    if (unloaded && parameters_.results.pictures)
      output::write_unloading_slices(original_->image, original_->breast, *unloaded, folder);
  }
};

} // namespace

bool run_unload(const AllParameters& parameters, const dealii::ParameterHandler& all,
                const ResultTarget& output, MPI_Comm world) {
  return UnloadJob(parameters, all, output, world).run();
}

} // namespace prosup::pipeline
