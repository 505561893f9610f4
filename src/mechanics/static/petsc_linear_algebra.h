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

/// A matrix with room for the tangent.
OwnedMatrix make_matrix(const Equilibrium& equations);

/// A matrix of blocks of 3 x 3 with room for the tangent without its products. It is assembled in
/// 2/3 of the time of one of single entries.
OwnedMatrix make_sparse_matrix(const Equilibrium& equations);

/// LU of MUMPS, or GMRES with GAMG.
void set_linear_solver(KSP ksp, LinearSolver solver);

/// GMRES and GAMG with a symmetric sweep of Gauss-Seidel before and after each coarse level. Only
/// the preconditioning matrix is asked for its entries; the other one may be a shell.
void set_gauss_seidel_multigrid(KSP ksp);

} // namespace prosup::mechanics::petsc

#endif
