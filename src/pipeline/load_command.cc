#include "prosup/mechanics/quasi_static.h"
#include "prosup/mesh/deformation.h"
#include "prosup/output/pictures.h"
#include "prosup/output/vtu.h"
#include "single_state_job.h"

namespace prosup::pipeline {

using mechanics::NodeVector;

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
  bool has_mesh() const { return !stages_.loading.mesh.empty(); }

  /// A mesh makes the labels needless, unless there is an image.
  void read() override {
    if (!has_mesh() || !stages_.scene.images[state_].empty())
      SingleStateJob::read();
  }

  mesh::TetMesh make_mesh() override {
    if (!has_mesh())
      return SingleStateJob::make_mesh();
    return exchanged(output::read_mesh(stages_.loading.mesh)).mesh;
  }

  mesh::UnloadedMesh simulate(const mesh::TetMesh& mesh) override {
    const auto body = make_body(mesh);
    NodeVector loaded = stages_.loading.is_explicit() ? settle(*body) : solve(*body);
    loaded += body->vertex_positions();
    loaded.update_ghost_values();
    mesh::UnloadedMesh result{mesh, mesh.points};
    result.mesh.points = mesh::at_nodes(mesh, body->gather_at_cells(loaded));
    return result;
  }

  /// Displacement by damped motion.
  NodeVector settle(const mechanics::Body& body) {
    unloading::Unloading motion(stages_.unloading, body, stages_.scene.gravity[state_], name_,
                                log_);
    motion.hold_reference();
    motion.set_material(material(body));
    const unloading::UnloadingResult result = motion.run();
    log_.line(describe(name_, result));
    n_steps_ = result.n_steps;
    converged_ = result.converged;
    return motion.displacement();
  }

  /// Displacement by Newton's method.
  NodeVector solve(const mechanics::Body& body) {
    mechanics::QuasiStatic quasi_static(stages_.quasi_static, body, log_);
    const auto& fixed = stages_.unloading.fixed_boundaries;
    quasi_static.set_material(material(body));
    quasi_static.set_fixed_nodes(body.nodes_on_boundary({fixed.begin(), fixed.end()}));
    quasi_static.set_body_force(body_force(stages_, state_));
    NodeVector displacement;
    body.initialize(displacement);
    displacement.update_ghost_values();
    const auto result = quasi_static.load(body.vertex_positions(), displacement);
    log_.line(describe(name_, result));
    n_steps_ = result.n_newton_steps;
    converged_ = result.converged;
    return displacement;
  }

  void write_images(const std::filesystem::path& folder) const override {
    write_field(mesh_, folder / ("unloaded_to_" + name_ + ".nrrd"));
    const image::VectorImage field =
        write_field(exchanged(mesh_), folder / (name_ + "_to_unloaded.nrrd"));
    const auto loaded = write_warped(field, folder / (name_ + "_loaded.nii.gz"));
    if (loaded && stages_.results.pictures)
      output::write_loading_slices(original_->image, original_->breast, *loaded, folder);
  }
};

} // namespace

bool run_load(const Stages& stages, const dealii::ParameterHandler& parameters,
              const std::filesystem::path& output, MPI_Comm world) {
  return LoadJob(stages, world).run(parameters, output);
}

} // namespace prosup::pipeline
