#ifndef PROSUP_SRC_START_UP_H
#define PROSUP_SRC_START_UP_H

namespace prosup {

/// Whether this is the first of the processes that mpirun has started, or the only one; known
/// before MPI is.
bool is_first_rank();

/// Keeps Open MPI from starting a daemon for a process that mpirun has not started: it would be for
/// starting further processes, and needs files, memory and a folder of its own. For before
/// MPI_Init().
void start_without_daemon();

} // namespace prosup

#endif
