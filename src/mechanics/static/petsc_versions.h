#ifndef PROSUP_MECHANICS_PETSC_VERSIONS_H
#define PROSUP_MECHANICS_PETSC_VERSIONS_H

#include <petscversion.h>

// Names of today's PETSc, for versions that have other ones.
#if PETSC_VERSION_LT(3, 21, 0)
#define SNESLineSearchShellSetApply SNESLineSearchShellSetUserFunc
#endif

#endif
