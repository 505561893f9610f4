#ifndef PROSUP_PIPELINE_COMMAND_LINE_H
#define PROSUP_PIPELINE_COMMAND_LINE_H

#include <mpi.h>

namespace prosup::pipeline {

/// The prosup program on top of an initialised MPI: reads the command line,
/// runs the command on all ranks of `world`, and returns the exit code: 0 for
/// success, 1 after one sentence on standard error, 2 if results were written
/// but a simulation did not settle.
int run_command_line(int argc, char** argv, MPI_Comm world);

} // namespace prosup::pipeline

#endif
