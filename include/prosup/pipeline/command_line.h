#ifndef PROSUP_PIPELINE_COMMAND_LINE_H
#define PROSUP_PIPELINE_COMMAND_LINE_H

#include <mpi.h>

namespace prosup::pipeline {

/// The program prosup, for a main() that has initialised MPI. Reads the command line and runs the
/// command on all ranks of `world`. Returns the exit code: 0 for success, 1 for an error (one
/// sentence on standard error), and the other values of Outcome. Signals are the business of
/// main(); see core/unfinished.h.
int run_command_line(int argc, char** argv, MPI_Comm world);

} // namespace prosup::pipeline

#endif
