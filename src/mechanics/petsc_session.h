#ifndef PROSUP_MECHANICS_PETSC_SESSION_H
#define PROSUP_MECHANICS_PETSC_SESSION_H

namespace prosup::mechanics {

/// Starts PETSc on this rank if the host has not done so; it then ends with
/// MPI_Finalize. Not collective, so that a part of the ranks can use PETSc.
void start_petsc();

} // namespace prosup::mechanics

#endif
