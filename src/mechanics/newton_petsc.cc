#include <petscsnes.h>

#include <algorithm>
#include <exception>
#include <memory>
#include <type_traits>

#include "newton.h"
#include "petsc_session.h"
#include "prosup/core/error.h"

namespace prosup::mechanics {

using namespace dealii;

namespace {

void check(PetscErrorCode code) {
  if (code == 0)
    return;
  const char* text = nullptr;
  PetscErrorMessage(code, &text, nullptr);
  throw Error(std::string("PETSc failed in the quasi-static solver (") +
              (text != nullptr ? text : "unknown reason") +
              "); choose another 'Quasi-static/Linear algebra'.");
}

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

class PetscNewton : public NewtonSolver {
public:
  PetscNewton(const Equilibrium& equations, LinearSolver solver) : solver_(solver) {
    start_petsc();
    const QuietErrors quiet;
    const Body& body = equations.body();
    body.initialize(position_);
    body.initialize(force_);
    create_vectors(body);
    create_matrix(equations);
    create_solver(body.communicator());
  }

  NewtonReport solve(const Equilibrium& equations, NodeVector& unknown,
                     const NewtonLimits& limits) override {
    const QuietErrors quiet;
    equations_ = &equations;
    failure_ = nullptr;
    set_rigid_modes(unknown);
    copy(unknown.begin(), solution_.get());
    check(SNESSetTolerances(snes_.get(), limits.residual_norm, 0., 0.,
                            static_cast<PetscInt>(limits.max_steps), -1));
    const PetscErrorCode code = SNESSolve(snes_.get(), nullptr, solution_.get());
    if (failure_)
      std::rethrow_exception(failure_);
    check(code);
    copy(solution_.get(), unknown);
    return report();
  }

private:
  void create_vectors(const Body& body) {
    Vec vector = nullptr;
    check(VecCreate(body.communicator(), &vector));
    solution_.reset(vector);
    check(VecSetSizes(vector, 3 * static_cast<PetscInt>(body.n_owned_nodes()), PETSC_DETERMINE));
    check(VecSetBlockSize(vector, 3));
    check(VecSetType(vector, VECSTANDARD));
    Vec second = nullptr;
    check(VecDuplicate(vector, &second));
    residual_.reset(second);
  }

  void create_matrix(const Equilibrium& equations) {
    const Body& body = equations.body();
    const PetscInt n = static_cast<PetscInt>(body.n_owned_nodes());
    Mat matrix = nullptr;
    check(MatCreate(body.communicator(), &matrix));
    matrix_.reset(matrix);
    check(MatSetSizes(matrix, 3 * n, 3 * n, PETSC_DETERMINE, PETSC_DETERMINE));
    check(MatSetBlockSize(matrix, 3));
    check(MatSetType(matrix, MATAIJ));
    const auto pattern = equations.node_pattern();
    PetscInt begin = 0;
    check(VecGetOwnershipRange(solution_.get(), &begin, nullptr));
    begin /= 3;
    std::vector<PetscInt> n_owned(static_cast<std::size_t>(n), 0), n_other(n_owned);
    for (PetscInt row = 0; row < n; ++row)
      for (auto entry = pattern.begin(begin + row); entry != pattern.end(begin + row); ++entry) {
        const PetscInt column = static_cast<PetscInt>(entry->column());
        ++(column >= begin && column < begin + n ? n_owned : n_other)[static_cast<unsigned>(row)];
      }
    check(MatXAIJSetPreallocation(matrix, 3, n_owned.data(), n_other.data(), nullptr, nullptr));
  }

  void create_solver(MPI_Comm communicator) {
    SNES snes = nullptr;
    check(SNESCreate(communicator, &snes));
    snes_.reset(snes);
    check(SNESSetType(snes, SNESNEWTONLS));
    check(SNESSetFunction(snes, residual_.get(), &PetscNewton::evaluate_residual, this));
    check(SNESSetJacobian(snes, matrix_.get(), matrix_.get(), &PetscNewton::evaluate_tangent, this));
    // An inexact solution is a direction still: the line search decides.
    check(SNESSetMaxLinearSolveFailures(snes, -1));
    SNESLineSearch search = nullptr;
    check(SNESGetLineSearch(snes, &search));
    check(SNESLineSearchSetType(search, SNESLINESEARCHBT));
    check(SNESLineSearchSetTolerances(search, 1e-8, 1e8, 1e-8, 1e-15, 1e-8, max_shortenings));
    KSP ksp = nullptr;
    PC pc = nullptr;
    check(SNESGetKSP(snes, &ksp));
    check(KSPGetPC(ksp, &pc));
    if (solver_ == LinearSolver::direct) {
      check(KSPSetType(ksp, KSPPREONLY));
      check(PCSetType(pc, PCLU));
      check(PCFactorSetMatSolverType(pc, MATSOLVERMUMPS));
      return;
    }
    check(KSPSetType(ksp, KSPGMRES));
    check(KSPGMRESSetRestart(ksp, linear_restart));
    check(KSPSetPCSide(ksp, PC_RIGHT));
    check(KSPSetTolerances(ksp, linear_tolerance, 1e-50, 1e10, max_linear_iterations));
    check(PCSetType(pc, PCGAMG));
    check(PCGAMGSetType(pc, PCGAMGAGG));
    PetscReal threshold = 0.01;
    check(PCGAMGSetThreshold(pc, &threshold, 1));
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
  Owned<Vec, VecDestroy> solution_, residual_;
  Owned<Mat, MatDestroy> matrix_;
  Owned<SNES, SNESDestroy> snes_;
};

} // namespace

std::unique_ptr<NewtonSolver> make_petsc_newton(const Equilibrium& equations, LinearSolver solver) {
  return std::make_unique<PetscNewton>(equations, solver);
}

} // namespace prosup::mechanics
