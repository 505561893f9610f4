#ifndef PROSUP_CORE_COLLECTIVE_H
#define PROSUP_CORE_COLLECTIVE_H

#include <mpi.h>

#include <functional>
#include <limits>
#include <vector>

#include "prosup/core/error.h"

namespace prosup {

/// Runs `work` on rank 0 only. If it throws, all ranks throw an Error with the same message, so
/// that no rank waits for another. Collective.
void on_root(MPI_Comm communicator, const std::function<void()>& work);

/// Runs `work` on every rank. If it throws on some ranks, all ranks throw an Error with the message
/// of the lowest of them. `work` may communicate only within groups whose ranks either all throw or
/// all succeed. Collective.
void on_every_rank(MPI_Comm communicator, const std::function<void()>& work);

/// Copies `values` from rank `from` to rank `to`. Only these two ranks have to call it. T is a
/// trivially copyable type without pointers.
/// @throws Error if the data exceed what one MPI message can hold.
template <typename T>
void transfer(std::vector<T>& values, int from, int to, MPI_Comm communicator) {
  if (from == to)
    return;
  int rank = 0;
  MPI_Comm_rank(communicator, &rank);
  unsigned long size = values.size();
  if (rank == from) {
    MPI_Send(&size, 1, MPI_UNSIGNED_LONG, to, 0, communicator);
    if (size * sizeof(T) > std::numeric_limits<int>::max())
      throw Error("A mesh is too large to be sent between two ranks; choose a longer edge.");
    MPI_Send(values.data(), static_cast<int>(size * sizeof(T)), MPI_BYTE, to, 0, communicator);
  } else if (rank == to) {
    MPI_Recv(&size, 1, MPI_UNSIGNED_LONG, from, 0, communicator, MPI_STATUS_IGNORE);
    values.resize(size);
    MPI_Recv(values.data(), static_cast<int>(size * sizeof(T)), MPI_BYTE, from, 0, communicator,
             MPI_STATUS_IGNORE);
  }
}

} // namespace prosup

#endif
