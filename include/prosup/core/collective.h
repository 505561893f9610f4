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

/// The values of all ranks, one rank after the other, on every rank. T is a trivially copyable type
/// without pointers. (dealii::Utilities::MPI::all_gather compresses them, which takes longer than
/// sending.) Collective.
template <typename T>
std::vector<T> all_gathered(const std::vector<T>& values, MPI_Comm communicator) {
  int n_ranks = 1;
  MPI_Comm_size(communicator, &n_ranks);
  const int n = static_cast<int>(values.size());
  std::vector<int> sizes(static_cast<std::size_t>(n_ranks)), begins(sizes.size(), 0);
  MPI_Allgather(&n, 1, MPI_INT, sizes.data(), 1, MPI_INT, communicator);
  for (std::size_t rank = 1; rank < sizes.size(); ++rank)
    begins[rank] = begins[rank - 1] + sizes[rank - 1];
  std::vector<T> all(static_cast<std::size_t>(begins.back() + sizes.back()));
  MPI_Datatype type = MPI_DATATYPE_NULL;
  MPI_Type_contiguous(sizeof(T), MPI_BYTE, &type);
  MPI_Type_commit(&type);
  MPI_Allgatherv(values.data(), n, type, all.data(), sizes.data(), begins.data(), type,
                 communicator);
  MPI_Type_free(&type);
  return all;
}

} // namespace prosup

#endif
