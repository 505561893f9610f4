#include "prosup/core/error.h"
#include "prosup/output/pictures.h"
#include "prosup/output/vtu.h"
#include "prosup/pipeline/commands.h"
#include "single_state_job.h"

namespace prosup::pipeline {

namespace {

/// A mesh with its configurations exchanged: fields of the other direction.
mesh::UnloadedMesh exchanged(mesh::UnloadedMesh mesh) {
  std::swap(mesh.mesh.points, mesh.unloaded);
  return mesh;
}

/// One unloaded breast to its loaded configuration.
class LoadJob : public SingleStateJob {
public:
  LoadJob(const AllParameters& parameters, const dealii::ParameterHandler& all,
          const ResultTarget& output, MPI_Comm world)
      : SingleStateJob(parameters, all, output, world, "load", "Loading") {}

private:
  bool has_mesh() const { return !parameters_.single_state.mesh.empty(); }

  /// A mesh makes the labels needless, unless there is an image or tissue slides.
  void read() override {
    const registration::CaseFiles& files = parameters_.case_files.files();
    if (has_mesh())
      unloaded_.given = exchanged(output::read_mesh(parameters_.single_state.mesh)).mesh;
    if (!has_mesh() || !files.images[position_].empty() ||
        parameters_.model().supports.need_labels(files.chest))
      SingleStateJob::read();
  }

  const mesh::MeshSource* mesh_source() const override { return has_mesh() ? &unloaded_ : nullptr; }

  settling::SettlingResult settle(registration::Breast& breast) override { return breast.load(); }
  registration::QuasiStaticSolution solve(registration::ElementBreast& breast,
                                          const registration::QuasiStaticInput& input) override {
    return load_quasi_statically(breast, input);
  }

  void write_images(const std::filesystem::path& folder) const override {
    write_field(mesh_, folder / ("unloaded_to_" + name_ + ".nrrd"));
    const image::VectorImage field =
        write_field(exchanged(mesh_), folder / (name_ + "_to_unloaded.nrrd"));
    const auto loaded = write_warped(field, folder / (name_ + "_loaded.nii.gz"));
    if (loaded && parameters_.results.pictures)
      output::write_loading_slices(original_->image, original_->breast, *loaded, folder);
  }

  GivenMesh unloaded_;
};

} // namespace

bool run_load(const AllParameters& parameters, const dealii::ParameterHandler& all,
              const ResultTarget& output, MPI_Comm world) {
  const std::string& method = parameters.model().simulation.method;
  if (method != "fe")
    throw Error("'Simulation/Method' is " + method +
                ", but load knows finite elements only; use --method fe.");
  return LoadJob(parameters, all, output, world).run();
}

} // namespace prosup::pipeline
