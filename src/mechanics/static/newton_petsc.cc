#include <petscsnes.h>

#include <algorithm>
#include <exception>
#include <limits>
#include <memory>

#include "newton.h"
#include "petsc_linear_algebra.h"
#include "petsc_versions.h"

namespace prosup::mechanics {

using namespace dealii;

namespace {

using petsc::check;
using petsc::Owned;
using petsc::QuietErrors;

/// The negative numbers that stand for it depend on the version.
constexpr PetscInt no_limit = std::numeric_limits<PetscInt>::max();

class PetscNewton : public NewtonSolver {
public:
  PetscNewton(const Equilibrium& equations, LinearSolver solver) : solver_(solver) {
    petsc::start();
    const QuietErrors quiet;
    const Body& body = equations.body();
    body.initialize(position_);
    body.initialize(force_);
    solution_ = petsc::make_vector(body);
    residual_ = petsc::make_vector(body);
    matrix_ = petsc::make_matrix(equations);
    create_nonlinear_solver(body.communicator());
  }

  NewtonReport solve(const Equilibrium& equations, NodeVector& unknown,
                     const NewtonLimits& limits) override {
    const QuietErrors quiet;
    equations_ = &equations;
    failure_ = nullptr;
    backtracking_ = {};
    set_rigid_modes(unknown);
    copy(unknown.begin(), solution_.get());
    check(SNESSetTolerances(snes_.get(), limits.residual_norm, 0., 0.,
                            static_cast<PetscInt>(limits.max_steps), no_limit));
    const PetscErrorCode code = SNESSolve(snes_.get(), nullptr, solution_.get());
    if (failure_)
      std::rethrow_exception(failure_);
    check(code);
    copy(solution_.get(), unknown);
    return report();
  }

private:
  void create_nonlinear_solver(MPI_Comm communicator) {
    SNES snes = nullptr;
    check(SNESCreate(communicator, &snes));
    snes_.reset(snes);
    check(SNESSetType(snes, SNESNEWTONLS));
    check(SNESSetFunction(snes, residual_.get(), &PetscNewton::evaluate_residual, this));
    check(
        SNESSetJacobian(snes, matrix_.get(), matrix_.get(), &PetscNewton::evaluate_tangent, this));
    // An inexact solution is a direction still: the line search decides.
    check(SNESSetMaxLinearSolveFailures(snes, no_limit));
    SNESLineSearch search = nullptr;
    check(SNESGetLineSearch(snes, &search));
    check(SNESLineSearchSetType(search, SNESLINESEARCHSHELL));
    check(SNESLineSearchShellSetApply(search, &PetscNewton::backtrack, this));
    KSP ksp = nullptr;
    check(SNESGetKSP(snes, &ksp));
    petsc::set_linear_solver(ksp, solver_);
  }

  /// Tells the multigrid the rigid body modes of nodes at `positions`.
  void set_rigid_modes(const NodeVector& positions) {
    if (solver_ != LinearSolver::multigrid)
      return;
    copy(positions.begin(), solution_.get());
    MatNullSpace modes = nullptr;
    check(MatNullSpaceCreateRigidBody(solution_.get(), &modes));
    const Owned<MatNullSpace, MatNullSpaceDestroy> owned(modes);
    check(MatSetNearNullSpace(matrix_.get(), modes));
  }

  NewtonReport report() const {
    NewtonReport report;
    SNESConvergedReason reason = SNES_CONVERGED_ITERATING;
    PetscInt n_steps = 0, n_linear = 0;
    check(SNESGetConvergedReason(snes_.get(), &reason));
    check(SNESGetIterationNumber(snes_.get(), &n_steps));
    check(SNESGetLinearSolveIterations(snes_.get(), &n_linear));
    check(SNESGetFunctionNorm(snes_.get(), &report.residual_norm));
    report.converged = reason > 0;
    report.n_steps = static_cast<unsigned>(n_steps);
    report.n_linear_iterations = static_cast<unsigned>(n_linear);
    return report;
  }

  void copy(const double* from, Vec to) const {
    PetscScalar* values = nullptr;
    check(VecGetArray(to, &values));
    std::copy_n(from, position_.locally_owned_size(), values);
    check(VecRestoreArray(to, &values));
  }

  static void copy(Vec from, NodeVector& to) {
    const PetscScalar* values = nullptr;
    check(VecGetArrayRead(from, &values));
    std::copy_n(values, to.locally_owned_size(), to.begin());
    check(VecRestoreArrayRead(from, &values));
    to.update_ghost_values();
  }

  /// Runs `work` for a callback of PETSc, through which no exception may pass.
  template <typename Work>
  PetscErrorCode guarded(const Work& work) {
    try {
      work();
      return 0;
    } catch (...) {
      failure_ = std::current_exception();
      return PETSC_ERR_USER;
    }
  }

  static PetscErrorCode evaluate_residual(SNES, Vec x, Vec f, void* context) {
    auto& self = *static_cast<PetscNewton*>(context);
    return self.guarded([&] {
      copy(x, self.position_);
      const double min_jacobian = self.equations_->residual(self.position_, self.force_);
      if (min_jacobian > 0.)
        self.copy(self.force_.begin(), f);
      else // the line search shortens a step to where the residual is infinite
        check(VecSet(f, std::numeric_limits<double>::infinity()));
    });
  }

  /// The line search. Interpolation between norms, as in SNES's own, shortens
  /// the steps far more than large rotations need.
  static PetscErrorCode backtrack(SNESLineSearch search, void* context) {
    auto& self = *static_cast<PetscNewton*>(context);
    SNES snes = nullptr;
    Vec x = nullptr, f = nullptr, step = nullptr, trial = nullptr, trial_f = nullptr;
    PetscReal norm = 0.;
    PetscCall(SNESLineSearchGetSNES(search, &snes));
    PetscCall(SNESLineSearchGetVecs(search, &x, &f, &step, &trial, &trial_f));
    PetscCall(SNESLineSearchGetNorms(search, nullptr, &norm, nullptr));
    PetscErrorCode code = 0;
    const double part = self.backtracking_.accepted_part(norm, [&](double tried) {
      PetscReal after = std::numeric_limits<double>::infinity();
      code = code != 0 ? code : VecWAXPY(trial, -tried, step, x);
      code = code != 0 ? code : SNESComputeFunction(snes, trial, trial_f);
      code = code != 0 ? code : VecNorm(trial_f, NORM_2, &after);
      return after;
    });
    PetscCall(code);
    if (!(part > 0.))
      return SNESLineSearchSetReason(search, SNES_LINESEARCH_FAILED_REDUCT);
    PetscCall(VecCopy(trial, x));
    PetscCall(VecCopy(trial_f, f));
    PetscCall(SNESLineSearchSetLambda(search, part));
    return SNESLineSearchComputeNorms(search);
  }

  static PetscErrorCode evaluate_tangent(SNES, Vec x, Mat matrix, Mat, void* context) {
    auto& self = *static_cast<PetscNewton*>(context);
    return self.guarded([&] {
      copy(x, self.position_);
      check(MatZeroEntries(matrix));
      self.equations_->tangent(self.position_, [matrix](const auto& nodes, const auto& values) {
        const PetscInt n = static_cast<PetscInt>(nodes.size());
        check(MatSetValuesBlocked(matrix, n, nodes.data(), n, nodes.data(), values.data(),
                                  ADD_VALUES));
      });
      check(MatAssemblyBegin(matrix, MAT_FINAL_ASSEMBLY));
      check(MatAssemblyEnd(matrix, MAT_FINAL_ASSEMBLY));
    });
  }

  const LinearSolver solver_;
  const Equilibrium* equations_ = nullptr;
  NodeVector position_, force_;
  std::exception_ptr failure_;
  Backtracking backtracking_;
  Owned<Vec, VecDestroy> solution_, residual_;
  Owned<Mat, MatDestroy> matrix_;
  Owned<SNES, SNESDestroy> snes_;
};

} // namespace

std::unique_ptr<NewtonSolver> make_petsc_newton(const Equilibrium& equations, LinearSolver solver) {
  return std::make_unique<PetscNewton>(equations, solver);
}

} // namespace prosup::mechanics
