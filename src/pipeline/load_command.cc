#include "prosup/core/error.h"
#include "prosup/mesh/deformation.h"
#include "prosup/output/pictures.h"
#include "prosup/output/vtu.h"
#include "single_state_job.h"

namespace prosup::pipeline {

namespace {

/// A mesh with its configurations exchanged: fields of the other direction.
mesh::UnloadedMesh exchanged(mesh::UnloadedMesh mesh) {
  std::swap(mesh.mesh.points, mesh.unloaded);
  return mesh;
}

/// One unloaded state to its loaded configuration.
class LoadJob : public SingleStateJob {
public:
  LoadJob(const Stages& stages, MPI_Comm world)
      : SingleStateJob(stages, world, "load", "Loading") {}

private:
  bool has_mesh() const { return !stages_.single_state.mesh.empty(); }

  /// A mesh makes the labels needless, unless there is an image or tissue slides.
  void read() override {
    if (has_mesh())
      file_mesh_ = output::read_mesh(stages_.single_state.mesh);
    if (!has_mesh() || !stages_.scene.images[state_].empty() ||
        stages_.supports.need_labels(stages_.scene.chest()))
      SingleStateJob::read();
  }

  mesh::TetMesh make_mesh() override {
    if (!has_mesh())
      return SingleStateJob::make_mesh();
    return exchanged(std::move(file_mesh_)).mesh;
  }

  mesh::UnloadedMesh simulate(mesh::TetMesh mesh) override {
    const auto body = make_body(stages_, mesh, world_);
    const mechanics::NodeVector loaded = equilibrium(*body, Direction::load);
    mesh::UnloadedMesh result{mesh, mesh.points};
    result.mesh.points = mesh::at_nodes(mesh, body->gather_at_cells(loaded));
    return result;
  }

  void write_images(const std::filesystem::path& folder) const override {
    write_field(mesh_, folder / ("unloaded_to_" + name_ + ".nrrd"));
    const image::VectorImage field =
        write_field(exchanged(mesh_), folder / (name_ + "_to_unloaded.nrrd"));
    const auto loaded = write_warped(field, folder / (name_ + "_loaded.nii.gz"));
    if (loaded && stages_.results.pictures)
      output::write_loading_slices(original_->image, original_->breast, *loaded, folder);
  }

  mesh::UnloadedMesh file_mesh_;
};

} // namespace

bool run_load(const Stages& stages, const dealii::ParameterHandler& parameters,
              const std::filesystem::path& output, MPI_Comm world) {
  if (stages.scene.method() != "fe")
    throw Error("'Case/Method' is " + stages.scene.method() +
                ", but load knows finite elements only; use --method fe.");
  return LoadJob(stages, world).run(parameters, output);
}

} // namespace prosup::pipeline
