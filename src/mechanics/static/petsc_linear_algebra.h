#ifndef PROSUP_MECHANICS_PETSC_LINEAR_ALGEBRA_H
#define PROSUP_MECHANICS_PETSC_LINEAR_ALGEBRA_H

#include <petscksp.h>

#include "newton.h"
#include "petsc_session.h"

namespace prosup::mechanics::petsc {

using OwnedVector = Owned<Vec, VecDestroy>;
using OwnedMatrix = Owned<Mat, MatDestroy>;

/// A vector with the components of a NodeVector.
OwnedVector make_vector(const Body& body);

/// A matrix with room for the tangent, or for it without its products.
OwnedMatrix make_matrix(const Equilibrium& equations, bool with_products = true);

/// LU of MUMPS, or GMRES with GAMG.
void set_linear_solver(KSP ksp, LinearSolver solver);

} // namespace prosup::mechanics::petsc

#endif
