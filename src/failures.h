#ifndef PROSUP_SRC_FAILURES_H
#define PROSUP_SRC_FAILURES_H

namespace prosup {

/// Lets want of memory end the program with one line and exit code 1, and removes what is
/// unfinished. An exception would have to pass through libraries that are not made for it.
void end_without_memory();

/// Lets a crash, also one in a library, end the program with one line and exit code 128 + number of
/// the signal. For after MPI_Init(), whose handlers allocate memory, which may wait for ever.
/// Where core files are wanted (ulimit -c), there is one.
void end_on_crash();

} // namespace prosup

#endif
