#include <mpi.h>

#include "prosup/pipeline/command_line.h"
#include "signals.h"

int main(int argc, char** argv) {
  prosup::watch_signals();
  MPI_Init(&argc, &argv);
  const int exit_code = prosup::pipeline::run_command_line(argc, argv, MPI_COMM_WORLD);
  MPI_Finalize();
  return exit_code;
}
