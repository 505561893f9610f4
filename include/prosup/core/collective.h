#ifndef PROSUP_CORE_COLLECTIVE_H
#define PROSUP_CORE_COLLECTIVE_H

#include <mpi.h>

#include <functional>

namespace prosup {

/// Runs `work` on rank 0 of the communicator only. If it throws, every rank
/// throws an Error with the same message, so that no rank waits for another.
void on_root(MPI_Comm communicator, const std::function<void()>& work);

/// Runs `work` on every rank; if it throws on some, every rank throws an Error
/// with the message of the first of them. `work` may communicate only within
/// groups whose ranks all throw or all succeed.
void on_every_rank(MPI_Comm communicator, const std::function<void()>& work);

} // namespace prosup

#endif
