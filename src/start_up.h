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

/// Keeps Open MPI off the network where mpirun runs all ranks on this machine: version 5 prints an
/// error there if an interface has an address of IPv6. For before MPI_Init().
void stay_on_this_machine();

} // namespace prosup

#endif
