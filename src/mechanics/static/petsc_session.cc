#include "petsc_session.h"

#include <string>

#include "prosup/core/error.h"

namespace prosup::mechanics::petsc {

namespace {

/// MPI deletes the attributes of MPI_COMM_SELF as the first act of MPI_Finalize.
int finalize_petsc(MPI_Comm, int, void*, void*) {
  if (PetscInitializeCalled && !PetscFinalizeCalled)
    PetscFinalize();
  return MPI_SUCCESS;
}

} // namespace

void start() {
  if (PetscInitializeCalled)
    return;
  // The host's signals, options and options files are its own. PETSc skips ~/.petscrc only if it is
  // told so by arguments, which it keeps.
  static char name[] = "prosup", skip[] = "-skip_petscrc", no_signals[] = "-no_signal_handler";
  static char* arguments[] = {name, skip, no_signals, nullptr};
  int n_arguments = 3;
  char** first = arguments;
  PETSC_COMM_WORLD = MPI_COMM_SELF;
  if (PetscInitialize(&n_arguments, &first, nullptr, nullptr) != 0)
    throw Error("PETSc cannot be started; choose a linear algebra of Trilinos in "
                "'Quasi-static/Linear algebra'.");
  int key = MPI_KEYVAL_INVALID;
  MPI_Comm_create_keyval(MPI_COMM_NULL_COPY_FN, finalize_petsc, &key, nullptr);
  MPI_Comm_set_attr(MPI_COMM_SELF, key, nullptr);
  MPI_Comm_free_keyval(&key);
}

void check(PetscErrorCode code) {
  if (code == 0)
    return;
  const char* text = nullptr;
  PetscErrorMessage(code, &text, nullptr);
  throw Error(std::string("PETSc failed to solve for an equilibrium (") +
              (text != nullptr ? text : "unknown reason") +
              "); choose another 'Quasi-static/Linear algebra'.");
}

} // namespace prosup::mechanics::petsc
