#include "prosup/registration/body_pair.h"

#include <deal.II/base/mpi.h>

#include "prosup/core/collective.h"
#include "prosup/mesh/tet_mesh.h"

namespace prosup::registration {

using settling::SettlingResult;
using similarity::LoadedState;
using similarity::prone;
using similarity::supine;

namespace {

constexpr std::array<State, 2> both{prone, supine};
constexpr auto chest_wall = static_cast<dealii::types::boundary_id>(mesh::BoundaryPart::chest_wall);

} // namespace

RankSplit::RankSplit(MPI_Comm world) {
  MPI_Comm_dup(world, &world_);
  int rank = 0, n_ranks = 1;
  MPI_Comm_rank(world_, &rank);
  MPI_Comm_size(world_, &n_ranks);
  const int n_prone = (n_ranks + 1) / 2;
  const bool on_prone = rank < n_prone;
  holds_ = {on_prone, !on_prone || n_ranks == 1};
  first_rank_ = {0, n_ranks == 1 ? 0 : n_prone};
  MPI_Comm_split(world_, on_prone ? 0 : 1, rank, &group_);
}

RankSplit::~RankSplit() {
  MPI_Comm_free(&group_);
  MPI_Comm_free(&world_);
}

std::array<SettlingResult, 2> RankSplit::share(std::array<SettlingResult, 2> results) const {
  for (const State state : both)
    results[state] = dealii::Utilities::MPI::broadcast(world_, results[state], first_rank(state));
  return results;
}

void BodyPair::for_each(const std::function<void(State, BodyState&)>& work) {
  on_every_rank(ranks_.world(), [&] {
    for (const State state : both)
      if (ranks_.holds(state))
        work(state, states_[state]);
  });
}

void BodyPair::set_properties(const mechanics::TissueMaterial& material,
                              const MechanicalProperties& properties) {
  properties_ = properties;
  for_each([&](State, BodyState& state) {
    state.supports->set_springs_on(chest_wall, properties.chest_stiffness);
    state.material = material.material_of(state.body->material_ids(), properties.tissue);
    state.unloading->set_material(state.material);
  });
}

bool BodyPair::has_gland(const mechanics::TissueMaterial& material) const {
  bool any = false;
  for (const State s : both)
    any = any || (ranks_.holds(s) && material.has_gland(states_[s].body->material_ids()));
  return dealii::Utilities::MPI::max(static_cast<int>(any), ranks_.world()) > 0;
}

std::array<SettlingResult, 2> BodyPair::unload(unsigned max_steps) {
  std::array<SettlingResult, 2> results;
  for_each(
      [&](State which, BodyState& state) { results[which] = state.unloading->run(max_steps); });
  return ranks_.share(results);
}

std::array<LoadedState, 2> BodyPair::loaded_states() const {
  std::array<LoadedState, 2> states;
  for (const State s : both)
    if (ranks_.holds(s))
      states[s] = {states_[s].body.get(), &states_[s].unloading->unloaded(), &states_[s].image};
  return states;
}

std::array<LoadedState, 2>
BodyPair::loaded_states(const std::array<image::ScalarImage, 2>& images) const {
  std::array<LoadedState, 2> states = loaded_states();
  for (const State s : both)
    if (states[s].body != nullptr)
      states[s].image = &images[s];
  return states;
}

BodyPair::Snapshot BodyPair::save() const {
  Snapshot snapshot;
  for (const State s : both)
    if (ranks_.holds(s))
      snapshot[s] = std::make_unique<unloading::Unloading::Snapshot>(states_[s].unloading->save());
  return snapshot;
}

void BodyPair::restore(const Snapshot& snapshot) {
  for (const State s : both)
    if (snapshot[s])
      states_[s].unloading->restore(*snapshot[s]);
}

} // namespace prosup::registration
