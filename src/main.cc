#include <mpi.h>

#include "failures.h"
#include "prosup/pipeline/command_line.h"
#include "signals.h"
#include "start_up.h"

int main(int argc, char** argv) {
  prosup::watch_signals();
  prosup::end_without_memory();
  prosup::start_without_daemon();
  prosup::stay_on_this_machine();
  MPI_Init(&argc, &argv);
  prosup::end_on_crash();
  const int exit_code = prosup::pipeline::run_command_line(argc, argv, MPI_COMM_WORLD);
  MPI_Finalize();
  return exit_code;
}
