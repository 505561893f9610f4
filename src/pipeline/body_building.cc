#include "prosup/pipeline/body_building.h"

#include <deal.II/base/mpi.h>

#include "prosup/core/collective.h"
#include "prosup/mesh/deformation.h"
#include "prosup/mesh/distributed.h"
#include "prosup/mesh/refine.h"

namespace prosup::pipeline {

using namespace dealii;
using registration::BodyPair;
using registration::BodyState;
using registration::State;
using similarity::prone;
using similarity::state_names;
using similarity::supine;

namespace {

void transfer_mesh(mesh::TetMesh& mesh, int from, int to, MPI_Comm communicator) {
  transfer(mesh.points, from, to, communicator);
  transfer(mesh.cells, from, to, communicator);
  transfer(mesh.tissue, from, to, communicator);
  transfer(mesh.boundary_faces, from, to, communicator);
}

} // namespace

std::unique_ptr<mechanics::Body> make_body(const Stages& stages, mesh::TetMesh& mesh,
                                           MPI_Comm communicator) {
  const mechanics::Element element = stages.elements.element();
  auto body =
      std::make_unique<mechanics::Body>(*mesh::make_distributed(mesh, communicator), element);
  if (element.degree() == 2)
    on_root(communicator, [&] { mesh = mesh::refined(mesh); });
  return body;
}

MeshPair build_bodies(const Stages& stages, Inputs& inputs, BodyPair& pair, const Log& log) {
  MeshPair meshes;
  const auto& ranks = pair.ranks();
  const MPI_Comm group = ranks.group();
  pair.for_each([&](State which, BodyState& state) {
    on_root(group, [&] { meshes[which] = stages.mesher.mesh(inputs.scene.labels[which]); });
    state.body = make_body(stages, meshes[which], group);
    state.supports =
        stages.supports.make(stages.scene.chest(), *state.body, inputs.scene.labels[which],
                             inputs.scene.labels[1 - which], stages.labels.chest);
    const Tensor<1, 3>& gravity = stages.scene.gravity[which];
    state.unloading = std::make_unique<unloading::Unloading>(
        stages.unloading, *state.supports,
        which == supine ? inputs.alignment.rotation * gravity : gravity, state_names[which],
        Log(group));
    state.image = std::move(inputs.images[which]);
  });
  const int rank = Utilities::MPI::this_mpi_process(ranks.world());
  if (rank == 0 || rank == ranks.first_rank(supine))
    transfer_mesh(meshes[supine], ranks.first_rank(supine), 0, ranks.world());
  // Results are in the coordinates of the original images.
  const image::RigidTransform to_supine = inputs.alignment.inverse();
  for (Point<3>& point : meshes[supine].points)
    point = to_supine(point);
  for (const State state : {prone, supine})
    log.line(format("  %s: %zu cells, %zu nodes", state_names[state], meshes[state].cells.size(),
                    meshes[state].points.size()));
  return meshes;
}

std::array<mesh::UnloadedMesh, 2> gather_unloaded(const MeshPair& meshes, const BodyPair& pair) {
  std::array<std::vector<std::array<Point<3>, 4>>, 2> at_cells;
  const auto& ranks = pair.ranks();
  const int rank = Utilities::MPI::this_mpi_process(ranks.world());
  for (const State state : {prone, supine}) {
    if (ranks.holds(state))
      at_cells[state] = pair[state].body->gather_at_cells(pair[state].unloading->unloaded());
    const int holder = ranks.first_rank(state);
    if (rank == 0 || rank == holder)
      transfer(at_cells[state], holder, 0, ranks.world());
  }
  std::array<mesh::UnloadedMesh, 2> unloaded;
  if (rank == 0)
    for (const State state : {prone, supine})
      unloaded[state] = {meshes[state], mesh::at_nodes(meshes[state], at_cells[state])};
  return unloaded;
}

void transfer_unloaded(mesh::UnloadedMesh& mesh, int from, int to, MPI_Comm communicator) {
  transfer_mesh(mesh.mesh, from, to, communicator);
  transfer(mesh.unloaded, from, to, communicator);
}

std::string describe(const std::string& name, const settling::SettlingResult& result) {
  return format("  %s: %u steps, residual %.1e, max |x-u-X| %.3f mm, min J %.2f%s%s%s",
                name.c_str(), result.n_steps, result.residual, result.distance, result.min_jacobian,
                result.converged ? "" : " (NOT settled)", result.explanation.empty() ? "" : "\n  ",
                result.explanation.c_str());
}

std::string describe(const std::string& name, const mechanics::QuasiStaticResult& result) {
  return format("  %s: %u Newton steps in %u load steps, residual %.1e, min J %.2f%s", name.c_str(),
                result.n_newton_steps, result.n_load_steps, result.residual, result.min_jacobian,
                result.converged ? "" : " (NOT converged)");
}

Tensor<1, 3> body_force(const Stages& stages, unsigned state) {
  const Tensor<1, 3>& direction = stages.scene.gravity[state];
  return stages.unloading.density * stages.unloading.gravity / direction.norm() * direction;
}

} // namespace prosup::pipeline
