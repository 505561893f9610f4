#include "prosup/registration/rank_split.h"

#include <deal.II/base/mpi.h>

namespace prosup::registration {

using settling::SettlingResult;

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

PerPosition<SettlingResult> RankSplit::share(PerPosition<SettlingResult> results) const {
  for (const Position position : both_positions)
    results[position] =
        dealii::Utilities::MPI::broadcast(world_, results[position], first_rank(position));
  return results;
}

} // namespace prosup::registration
