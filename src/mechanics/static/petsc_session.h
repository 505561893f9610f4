#ifndef PROSUP_MECHANICS_PETSC_SESSION_H
#define PROSUP_MECHANICS_PETSC_SESSION_H

#include <petscsys.h>

#include <memory>
#include <type_traits>

namespace prosup::mechanics::petsc {

/// Starts PETSc on this rank unless the host program has done so; PETSc then ends with
/// MPI_Finalize. Not collective, so that a subset of the ranks can use PETSc.
void start();

/// @throws Error if `code` is an error code of PETSc.
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

/// While an object of this type exists, PETSc returns errors instead of printing them.
struct QuietErrors {
  QuietErrors() { PetscPushErrorHandler(PetscReturnErrorHandler, nullptr); }
  ~QuietErrors() { PetscPopErrorHandler(); }
};

} // namespace prosup::mechanics::petsc

#endif
