#ifndef PROSUP_CORE_SESSION_H
#define PROSUP_CORE_SESSION_H

#include <deal.II/base/mpi.h>

namespace prosup {

/// MPI, and the libraries that need it, from construction to destruction: for programs that have no
/// use for MPI themselves. A program that starts MPI itself does not need it.
class Session {
public:
  Session(int argc, char** argv) : mpi_(argc, argv, 1) {}

  /// Whether this process is the one that should print: the only one, unless mpirun started more.
  bool is_first() const { return dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0; }

private:
  dealii::Utilities::MPI::MPI_InitFinalize mpi_;
};

} // namespace prosup

#endif
