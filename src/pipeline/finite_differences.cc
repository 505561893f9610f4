#include "finite_differences.h"

#include <deal.II/base/mpi.h>

#include <set>

#include "prosup/fdm/breast_mesh.h"
#include "prosup/pipeline/body_building.h"

namespace prosup::pipeline {

using namespace dealii;
using registration::State;
using similarity::prone;
using similarity::supine;

mesh::UnloadedMesh mesh_of_grid(const Stages& stages, const fdm::VectorField& displacement,
                                const image::LabelImage& labels) {
  std::set<unsigned> tissues(labels.values.begin(), labels.values.end());
  tissues.erase(0);
  tissues.erase(stages.labels.chest);
  fdm::BreastMesh breast = fdm::breast_mesh(displacement, labels, {tissues.begin(), tissues.end()});
  mesh::UnloadedMesh result;
  result.mesh.points = std::move(breast.loaded);
  result.mesh.cells = std::move(breast.cells);
  result.mesh.tissue = std::move(breast.tissue);
  result.unloaded = std::move(breast.unloaded);
  return result;
}

Tensor<1, 3> acceleration(const Stages& stages, const Tensor<1, 3>& direction) {
  return stages.unloading.gravity / direction.norm() * direction;
}

fdm::ChestContact chest_contact(const Stages& stages) {
  switch (stages.scene.chest()) {
  case unloading::ChestCondition::fixed:
    return fdm::ChestContact::fixed;
  case unloading::ChestCondition::sliding:
    return fdm::ChestContact::sliding;
  default:
    return fdm::ChestContact::one_sided;
  }
}

void FiniteDifferences::build(Inputs& inputs) {
  inputs_ = &inputs;
  const registration::GridSetup setup{
      stages_.fdm,
      stages_.material,
      stages_.similarity,
      {acceleration(stages_, stages_.scene.gravity[prone]),
       acceleration(stages_, inputs.alignment.rotation * stages_.scene.gravity[supine])},
      chest_contact(stages_),
      stages_.unloading.density};
  grids_ = std::make_unique<registration::SimulatedGrids>(
      ranks_, setup, inputs.scene, std::move(inputs.images),
      registration::MechanicalProperties{stages_.material.initial(),
                                         stages_.supports.chest_stiffness(stages_.scene.chest())});
}

registration::MaterialUpdateResult
FiniteDifferences::update_material(const registration::Observer& observer) {
  return stages_.material_update.run(*grids_, *stages_.similarity.make_metric(), log_, observer);
}

registration::ImageForceResult
FiniteDifferences::push_with_image_forces(const registration::Observer& observer) {
  return stages_.image_forces.accumulate(*grids_, log_, observer);
}

std::array<mesh::UnloadedMesh, 2> FiniteDifferences::unloaded() const {
  std::array<mesh::UnloadedMesh, 2> meshes;
  const int rank = Utilities::MPI::this_mpi_process(ranks_.world());
  const image::RigidTransform to_supine = inputs_->alignment.inverse();
  for (const State state : {prone, supine}) {
    const int holder = ranks_.first_rank(state);
    if (ranks_.holds(state)) {
      const fdm::VectorField displacement = grids_->displacement(state);
      if (rank == holder)
        meshes[state] = mesh_of_grid(stages_, displacement, inputs_->scene.labels[state]);
    }
    if (rank == 0 || rank == holder)
      transfer_unloaded(meshes[state], holder, 0, ranks_.world());
  }
  if (rank != 0)
    return {};
  for (Point<3>& point : meshes[supine].mesh.points)
    point = to_supine(point);
  return meshes;
}

} // namespace prosup::pipeline
