#include "prosup/registration/breast_pair.h"

#include <deal.II/base/mpi.h>

#include <utility>

#include "prosup/core/collective.h"
#include "prosup/mesh/transfer.h"

namespace prosup::registration {

using settling::SettlingResult;

BreastPair::BreastPair(const RankSplit& ranks, const MechanicalProperties& properties,
                       const Maker& make)
    : ranks_(ranks), properties_(properties) {
  on_every_rank(ranks_.world(), [&] {
    for (const Position position : both_positions)
      if (ranks_.holds(position))
        breasts_[position] = make(position, ranks_.group());
  });
}

void BreastPair::for_each(const std::function<void(Position, Breast&)>& work) const {
  on_every_rank(ranks_.world(), [&] {
    for (const Position position : both_positions)
      if (ranks_.holds(position))
        work(position, *breasts_[position]);
  });
}

bool BreastPair::all(const std::function<bool(Breast&)>& is_so) const {
  int here = 1;
  for_each([&](Position, Breast& breast) { here = here != 0 && is_so(breast) ? 1 : 0; });
  return dealii::Utilities::MPI::min(here, ranks_.world()) > 0;
}

bool BreastPair::consists_of_elements() const {
  return all([](Breast& breast) { return breast.elements() != nullptr; });
}

bool BreastPair::has_gland() const {
  return !all([](Breast& breast) { return !breast.has_gland(); });
}

void BreastPair::set_properties(const MechanicalProperties& properties) {
  properties_ = properties;
  for_each([&](Position, Breast& breast) { breast.set_properties(properties); });
}

PerPosition<SettlingResult> BreastPair::unload(const settling::Effort& effort) {
  PerPosition<SettlingResult> results;
  for_each([&](Position position, Breast& breast) { results[position] = breast.unload(effort); });
  return ranks_.share(std::move(results));
}

PerPosition<SettlingResult> BreastPair::advance(double duration) {
  PerPosition<SettlingResult> results;
  for_each(
      [&](Position position, Breast& breast) { results[position] = breast.advance(duration); });
  return ranks_.share(std::move(results));
}

void BreastPair::save() {
  for_each([](Position, Breast& breast) { breast.save(); });
}

void BreastPair::restore() {
  for_each([](Position, Breast& breast) { breast.restore(); });
}

PerPosition<mesh::UnloadedMesh> BreastPair::meshes() const {
  PerPosition<mesh::UnloadedMesh> meshes;
  for_each([&](Position position, Breast& breast) { meshes[position] = breast.mesh(); });
  const int rank = dealii::Utilities::MPI::this_mpi_process(ranks_.world());
  for (const Position position : both_positions) {
    const int holder = ranks_.first_rank(position);
    if (rank == 0 || rank == holder)
      mesh::transfer(meshes[position], holder, 0, ranks_.world());
  }
  if (rank != 0)
    return {};
  return meshes;
}

} // namespace prosup::registration
