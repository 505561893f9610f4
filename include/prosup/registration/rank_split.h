#ifndef PROSUP_REGISTRATION_RANK_SPLIT_H
#define PROSUP_REGISTRATION_RANK_SPLIT_H

#include <mpi.h>

#include "prosup/core/position.h"
#include "prosup/settling/settling_result.h"

namespace prosup::registration {

/// Shares the ranks of a communicator between the two positions, which need each other only when
/// images are compared: with two or more ranks, the first half (rounded up) works on prone and the
/// others on supine; one rank does both.
class RankSplit {
public:
  explicit RankSplit(MPI_Comm world);
  ~RankSplit();
  RankSplit(const RankSplit&) = delete;
  RankSplit& operator=(const RankSplit&) = delete;

  MPI_Comm world() const { return world_; }
  /// The ranks that work on the same position(s) as this one.
  MPI_Comm group() const { return group_; }
  bool holds(Position position) const { return holds_[position]; }
  /// Rank in world() of the first rank that works on a position.
  int first_rank(Position position) const { return first_rank_[position]; }

  /// Tells all ranks the results of both positions, which those that hold them know.
  PerPosition<settling::SettlingResult> share(PerPosition<settling::SettlingResult> results) const;

private:
  MPI_Comm world_;
  MPI_Comm group_;
  PerPosition<bool> holds_;
  PerPosition<int> first_rank_;
};

} // namespace prosup::registration

#endif
