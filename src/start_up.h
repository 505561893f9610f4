#ifndef PROSUP_SRC_START_UP_H
#define PROSUP_SRC_START_UP_H

namespace prosup {

/// Whether this is the first of the processes that mpirun has started, or the only one; known
/// before MPI is.
bool is_first_rank();

} // namespace prosup

#endif
