#include "petsc_linear_algebra.h"

#include <string>
#include <vector>

namespace prosup::mechanics::petsc {

using namespace dealii;

OwnedVector make_vector(const Body& body) {
  Vec vector = nullptr;
  check(VecCreate(body.communicator(), &vector));
  OwnedVector owned(vector);
  check(VecSetSizes(vector, 3 * static_cast<PetscInt>(body.n_owned_nodes()), PETSC_DETERMINE));
  check(VecSetBlockSize(vector, 3));
  check(VecSetType(vector, VECSTANDARD));
  return owned;
}

namespace {

OwnedMatrix make_node_blocks(const Equilibrium& equations, MatType type, bool with_products) {
  const PetscInt n = static_cast<PetscInt>(equations.body().n_owned_nodes());
  Mat matrix = nullptr;
  check(MatCreate(equations.body().communicator(), &matrix));
  OwnedMatrix owned(matrix);
  check(MatSetSizes(matrix, 3 * n, 3 * n, PETSC_DETERMINE, PETSC_DETERMINE));
  check(MatSetBlockSize(matrix, 3));
  check(MatSetType(matrix, type));

  PetscInt begin = 0;
  const OwnedVector layout = make_vector(equations.body());
  check(VecGetOwnershipRange(layout.get(), &begin, nullptr));
  begin /= 3;
  const DynamicSparsityPattern pattern = equations.node_pattern(with_products);
  std::vector<PetscInt> n_own_columns(static_cast<std::size_t>(n), 0),
      n_other_columns(n_own_columns);
  for (PetscInt row = 0; row < n; ++row)
    for (auto entry = pattern.begin(begin + row); entry != pattern.end(begin + row); ++entry) {
      const PetscInt column = static_cast<PetscInt>(entry->column());
      const bool own = column >= begin && column < begin + n;
      ++(own ? n_own_columns : n_other_columns)[static_cast<std::size_t>(row)];
    }
  check(MatXAIJSetPreallocation(matrix, 3, n_own_columns.data(), n_other_columns.data(), nullptr,
                                nullptr));
  return owned;
}

void set_gmres(KSP ksp) {
  check(KSPSetType(ksp, KSPGMRES));
  check(KSPGMRESSetRestart(ksp, linear_restart));
  check(KSPSetPCSide(ksp, PC_RIGHT));
}

void set_multigrid(PC pc) {
  check(PCSetType(pc, PCGAMG));
  check(PCGAMGSetType(pc, PCGAMGAGG));
  // Fastest of what was tried on hanging boxes: the coarse matrices of smoothed
  // aggregates cost more than the iterations that they save.
  check(PCGAMGSetNSmooths(pc, 0));
  PetscReal threshold = 0.;
  check(PCGAMGSetThreshold(pc, &threshold, 1));
  check(PCGAMGSetAggressiveLevels(pc, 1));
  check(PCGAMGSetReuseInterpolation(pc, PETSC_TRUE));
}

} // namespace

OwnedMatrix make_matrix(const Equilibrium& equations) {
  return make_node_blocks(equations, MATAIJ, true);
}

OwnedMatrix make_sparse_matrix(const Equilibrium& equations) {
  return make_node_blocks(equations, MATBAIJ, false);
}

void set_linear_solver(KSP ksp, LinearSolver solver) {
  PC pc = nullptr;
  check(KSPGetPC(ksp, &pc));
  if (solver == LinearSolver::direct) {
    check(KSPSetType(ksp, KSPPREONLY));
    check(PCSetType(pc, PCLU));
    check(PCFactorSetMatSolverType(pc, MATSOLVERMUMPS));
    return;
  }
  set_gmres(ksp);
  check(KSPSetTolerances(ksp, linear_tolerance, 1e-50, 1e10, max_linear_iterations));
  set_multigrid(pc);
}

void set_gauss_seidel_multigrid(KSP ksp) {
  // GAMG takes its smoothers from options only.
  const std::string prefix = "prosup_sweeps_", levels = "-" + prefix + "mg_levels_";
  check(PetscOptionsSetValue(nullptr, (levels + "ksp_type").c_str(), "richardson"));
  check(PetscOptionsSetValue(nullptr, (levels + "ksp_max_it").c_str(), "1"));
  check(PetscOptionsSetValue(nullptr, (levels + "pc_type").c_str(), "sor"));
  check(KSPSetOptionsPrefix(ksp, prefix.c_str()));
  set_gmres(ksp);
  PC pc = nullptr;
  check(KSPGetPC(ksp, &pc));
  set_multigrid(pc);
  check(PCGAMGSetAggressiveLevels(pc, 0));
  check(PCSetUseAmat(pc, PETSC_FALSE));
}

} // namespace prosup::mechanics::petsc
