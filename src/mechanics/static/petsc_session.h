#ifndef PROSUP_MECHANICS_PETSC_SESSION_H
#define PROSUP_MECHANICS_PETSC_SESSION_H

#include <petscsys.h>

#include <memory>
#include <type_traits>

namespace prosup::mechanics::petsc {

/// Starts PETSc on this rank if the host has not done so; it then ends with
/// MPI_Finalize. Not collective, so that a part of the ranks can use PETSc.
void start();

/// @throws Error for an error code of PETSc.
void check(PetscErrorCode code);

/// Destroys a PETSc object, unless PETSc has ended before.
template <auto destroy>
struct Destroy {
  template <typename Object>
  void operator()(Object* object) const {
    if (!PetscFinalizeCalled)
      destroy(&object);
  }
};
template <typename Handle, auto destroy>
using Owned = std::unique_ptr<std::remove_pointer_t<Handle>, Destroy<destroy>>;

/// Makes PETSc hand its errors on to us instead of printing them.
struct QuietErrors {
  QuietErrors() { PetscPushErrorHandler(PetscReturnErrorHandler, nullptr); }
  ~QuietErrors() { PetscPopErrorHandler(); }
};

} // namespace prosup::mechanics::petsc

#endif
