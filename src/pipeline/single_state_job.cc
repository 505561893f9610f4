#include "single_state_job.h"

#include <deal.II/base/mpi.h>

#include <utility>

#include "prosup/core/collective.h"
#include "prosup/core/parameters.h"
#include "prosup/core/result_folder.h"
#include "prosup/evaluation/point_mapper.h"
#include "prosup/image/filters.h"
#include "prosup/image/image_io.h"
#include "prosup/mesh/deformation.h"
#include "prosup/mesh/quality.h"
#include "prosup/output/displacement_fields.h"
#include "prosup/output/vtu.h"
#include "prosup/pipeline/unloaded_grid.h"

namespace prosup::pipeline {

namespace fs = std::filesystem;

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
    output::write_summary(summary(memory), folder->path() / "summary.json");
    folder->commit();
    log_.line("\n" + timer_.table() + "\n\nResults are in " + output.string());
  });
  return converged_;
}

void SingleStateJob::read() {
  labels_ = stages_.inputs.read_labels(stages_.scene, state_);
  original_ = stages_.inputs.read_image(stages_.scene, state_);
}

std::vector<mechanics::LameParameters> SingleStateJob::material(const mechanics::Body& body) const {
  return stages_.material.parameters_of(body.material_ids(),
                                        stages_.material.initial_shear_modulus());
}

mechanics::NodeVector SingleStateJob::equilibrium(const mechanics::Body& body,
                                                  Direction direction) {
  mechanics::NodeVector positions =
      stages_.single_state.is_explicit() ? settle(body, direction) : solve(body, direction);
  positions.update_ghost_values();
  return positions;
}

/// By damped motion.
mechanics::NodeVector SingleStateJob::settle(const mechanics::Body& body, Direction direction) {
  unloading::Unloading motion(stages_.unloading, body, stages_.scene.gravity[state_], name_, log_);
  if (direction == Direction::load)
    motion.hold_reference();
  motion.set_material(material(body));
  const unloading::UnloadingResult result = motion.run();
  log_.line(describe(name_, result));
  n_steps_ = result.n_steps;
  converged_ = result.converged;
  mechanics::NodeVector positions = motion.unloaded();
  if (direction == Direction::load)
    positions += motion.displacement();
  return positions;
}

/// By Newton's method.
mechanics::NodeVector SingleStateJob::solve(const mechanics::Body& body, Direction direction) {
  mechanics::QuasiStatic quasi_static(stages_.quasi_static, body, log_);
  const auto& fixed = stages_.unloading.fixed_boundaries;
  quasi_static.set_material(material(body));
  quasi_static.set_fixed_nodes(body.nodes_on_boundary({fixed.begin(), fixed.end()}));
  quasi_static.set_body_force(body_force(stages_, state_));
  mechanics::NodeVector positions = body.vertex_positions();
  positions.update_ghost_values();
  mechanics::QuasiStaticResult result;
  if (direction == Direction::unload) {
    result = quasi_static.unload(body.vertex_positions(), positions);
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
  image::ScalarImage warped = image::warp(original_->image, field);
  image::write_image(warped, file);
  return warped;
}

output::Summary SingleStateJob::summary(double memory) const {
  const mesh::MeshQuality quality = mesh::measure_quality(mesh_.mesh);
  output::Summary summary;
  summary.command = command_;
  summary.ranks = dealii::Utilities::MPI::n_mpi_processes(world_);
  (state_ == 0 ? summary.prone : summary.supine) = output::StateSummary{
      quality.n_cells, quality.n_nodes, quality.min_quality, mesh::min_jacobian(mesh_)};
  summary.steps = n_steps_;
  summary.shear_modulus = stages_.material.initial_shear_modulus();
  summary.time.mesh = timer_.seconds("Meshing");
  summary.time.unloading = timer_.seconds(simulation_);
  summary.time.total = timer_.total();
  summary.peak_memory = memory;
  summary.converged = converged_;
  return summary;
}

} // namespace prosup::pipeline
