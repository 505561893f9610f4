#include "single_state_job.h"

#include <deal.II/base/mpi.h>

#include <limits>
#include <utility>

#include "prosup/core/collective.h"
#include "prosup/core/parameters.h"
#include "prosup/core/result_folder.h"
#include "prosup/evaluation/point_mapper.h"
#include "prosup/image/broadcast.h"
#include "prosup/image/filters.h"
#include "prosup/image/image_io.h"
#include "prosup/mechanics/static/support_force.h"
#include "prosup/mesh/deformation.h"
#include "prosup/mesh/quality.h"
#include "prosup/output/displacement_fields.h"
#include "prosup/output/vtu.h"
#include "prosup/pipeline/result_images.h"
#include "prosup/pipeline/unloaded_grid.h"

namespace prosup::pipeline {

namespace fs = std::filesystem;

namespace {

constexpr double largest_change = 1e-3; // mm, of positions when areas have settled

double largest_difference(const mechanics::NodeVector& a, const mechanics::NodeVector& b) {
  mechanics::NodeVector difference = a;
  difference -= b;
  return difference.linfty_norm();
}

} // namespace

SingleStateJob::SingleStateJob(const Stages& stages, MPI_Comm world, std::string command,
                               std::string simulation)
    : stages_(stages), state_(stages.scene.state()), name_(similarity::state_names[state_]),
      world_(world), log_(world), command_(std::move(command)), simulation_(std::move(simulation)),
      timer_(world, log_) {}

bool SingleStateJob::run(const dealii::ParameterHandler& parameters, const fs::path& output) {
  std::unique_ptr<ResultFolder> folder;
  mesh::TetMesh mesh;
  on_root(world_, [&] { folder = std::make_unique<ResultFolder>(output); });
  timer_.run("Reading", [&] { on_root(world_, [&] { read(); }); });
  timer_.run("Meshing", [&] { on_root(world_, [&] { mesh = make_mesh(); }); });
  timer_.run(simulation_, [&] { mesh_ = simulate(std::move(mesh)); });
  timer_.run("Writing results",
             [&] { on_root(world_, [&] { write(parameters, folder->path()); }); });
  const double memory = peak_memory(world_);
  on_root(world_, [&] {
    const output::Summary results = summary(memory);
    output::write_summary(results, folder->path() / "summary.json");
    folder->commit();
    if (results.tre.unloaded)
      log_.line(format("  landmarks: %.2f mm mean, %.2f mm max from their true unloaded positions",
                       results.tre.unloaded->mean, results.tre.unloaded->max));
    log_.line("\n" + timer_.table() + "\n\nResults are in " + output.string());
  });
  return converged_;
}

void SingleStateJob::read() {
  landmarks_.read(stages_.scene);
  labels_ = stages_.inputs.read_labels(stages_.scene, state_);
  if (!stages_.scene.labels[1 - state_].empty() && stages_.supports.need_other_labels())
    other_labels_ = stages_.inputs.read_labels(stages_.scene, 1 - state_);
  original_ = stages_.inputs.read_image(stages_.scene, state_);
}

mechanics::Material SingleStateJob::material(const mechanics::Body& body) const {
  return stages_.material.material_of(body.material_ids(), stages_.material.initial());
}

mechanics::NodeVector SingleStateJob::equilibrium(const mechanics::Body& body,
                                                  Direction direction) {
  const auto supports = make_supports(body);
  mechanics::NodeVector positions = stages_.single_state.is_explicit()
                                        ? settle(*supports, direction)
                                        : solve(*supports, direction);
  positions.update_ghost_values();
  return positions;
}

std::unique_ptr<mechanics::Supports> SingleStateJob::make_supports(const mechanics::Body& body) {
  const unloading::ChestCondition chest = stages_.scene.chest();
  if (stages_.supports.need_labels(chest))
    image::broadcast(labels_, world_);
  image::broadcast(other_labels_, world_);
  return stages_.supports.make(chest, body, labels_, other_labels_, stages_.labels.chest);
}

/// By damped motion.
mechanics::NodeVector SingleStateJob::settle(mechanics::Supports& supports, Direction direction) {
  const mechanics::Body& body = supports.body();
  unloading::Unloading motion(stages_.unloading, supports, stages_.scene.gravity[state_], name_,
                              log_);
  if (direction == Direction::load)
    motion.hold_reference();
  motion.set_material(material(body));
  const settling::SettlingResult result = motion.run();
  log_.line(describe(name_, result));
  n_steps_ = result.n_steps;
  converged_ = result.converged;
  mechanics::NodeVector positions = motion.unloaded();
  if (direction == Direction::load)
    positions += motion.displacement();
  return positions;
}

/// By Newton's method.
mechanics::NodeVector SingleStateJob::solve(mechanics::Supports& supports, Direction direction) {
  const mechanics::Body& body = supports.body();
  mechanics::QuasiStatic quasi_static(stages_.quasi_static, body, log_);
  const auto nodal_force = mechanics::support_force(supports, stages_.supports.contact_stiffness);
  quasi_static.set_material(material(body));
  quasi_static.set_fixed_nodes(supports.fixed());
  quasi_static.set_nodal_force(nodal_force.get());
  quasi_static.set_body_force(body_force(stages_, state_));
  mechanics::NodeVector positions = body.vertex_positions();
  positions.update_ghost_values();
  mechanics::QuasiStaticResult result;
  supports.set_reference(positions);
  if (direction == Direction::unload) {
    // The areas on which springs act are those of the unloaded configuration.
    for (double change = std::numeric_limits<double>::max(); change > largest_change;) {
      const mechanics::NodeVector before = positions;
      result = quasi_static.unload(body.vertex_positions(), positions);
      supports.set_reference(positions);
      change = supports.spring_stiffness().empty() ? 0. : largest_difference(before, positions);
    }
  } else {
    mechanics::NodeVector displacement;
    body.initialize(displacement);
    displacement.update_ghost_values();
    result = quasi_static.load(body.vertex_positions(), displacement);
    positions += displacement;
  }
  log_.line(describe(name_, result));
  n_steps_ = result.n_newton_steps;
  converged_ = result.converged;
  return positions;
}

void SingleStateJob::write(const dealii::ParameterHandler& parameters,
                           const fs::path& folder) const {
  output::write_mesh(mesh_, folder, name_);
  write_parameters(parameters, folder / "used.prm");
  write_images(folder);
}

image::VectorImage SingleStateJob::write_field(const mesh::UnloadedMesh& mesh,
                                               const fs::path& file) const {
  const image::VoxelGrid grid =
      unloaded_grid({&mesh}, stages_.results.voxel_edge, stages_.results.margin);
  image::VectorImage field = output::unloaded_to_loaded(grid, mesh, evaluation::PointMapper(mesh));
  image::write_displacement(field, file);
  return field;
}

std::optional<image::ScalarImage> SingleStateJob::write_warped(const image::VectorImage& field,
                                                               const fs::path& file) const {
  if (!original_)
    return {};
  return pipeline::write_warped(original_->image, field, file);
}

output::Summary SingleStateJob::summary(double memory) const {
  const mesh::MeshQuality quality = mesh::measure_quality(mesh_.mesh);
  output::Summary summary;
  summary.command = command_;
  summary.ranks = dealii::Utilities::MPI::n_mpi_processes(world_);
  const mesh::JacobianRange jacobian = mesh::jacobian_range(mesh_);
  (state_ == 0 ? summary.prone : summary.supine) = output::StateSummary{
      quality.n_cells, quality.n_nodes, quality.min_quality, jacobian.min, jacobian.max};
  summary.steps = n_steps_;
  summary.tre.unloaded = error();
  summary.shear_modulus = stages_.material.initial().shear_modulus;
  summary.time.mesh = timer_.seconds("Meshing");
  summary.time.unloading = timer_.seconds(simulation_);
  summary.time.total = timer_.total();
  summary.peak_memory = memory;
  summary.converged = converged_;
  return summary;
}

} // namespace prosup::pipeline
