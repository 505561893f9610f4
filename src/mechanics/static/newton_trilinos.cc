#include <deal.II/base/mpi.h>
#include <deal.II/lac/trilinos_precondition.h>
#include <deal.II/lac/trilinos_solver.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>

#include <Teuchos_ParameterList.hpp>

#include <algorithm>
#include <cmath>

#include "newton.h"

namespace prosup::mechanics {

using namespace dealii;

namespace {

constexpr unsigned n_rigid_modes = 6;

/// Translations and rotations of nodes at `positions`, one mode after the other.
std::vector<double> rigid_modes(const Body& body, const NodeVector& positions) {
  const std::size_t n = 3 * static_cast<std::size_t>(body.n_owned_nodes());
  std::vector<double> modes(n_rigid_modes * n, 0.);
  for (unsigned node = 0; node < body.n_owned_nodes(); ++node) {
    const Tensor<1, 3> x = node_value(positions, node);
    for (unsigned axis = 0; axis < 3; ++axis) {
      Tensor<1, 3> unit;
      unit[axis] = 1.;
      const Tensor<1, 3> turn = cross_product_3d(unit, x);
      modes[axis * n + 3 * node + axis] = 1.;
      for (unsigned c = 0; c < 3; ++c)
        modes[(3 + axis) * n + 3 * node + c] = turn[c];
    }
  }
  return modes;
}

/// Smoothed aggregation for elasticity; `modes` stay where they are.
Teuchos::ParameterList multigrid_parameters(std::vector<double>& modes) {
  Teuchos::ParameterList list;
  list.set("default values", "SA");
  list.set("max levels", 10);
  list.set("ML output", 0);
  list.set("PDE equations", 3);
  list.set("null space: type", "pre-computed");
  list.set("null space: dimension", static_cast<int>(n_rigid_modes));
  list.set("null space: vectors", modes.data());
  list.set("aggregation: type", "Uncoupled");
  list.set("aggregation: threshold", 0.03);
  list.set("smoother: type", "Chebyshev");
  list.set("smoother: sweeps", 2);
  list.set("coarse: type", "Amesos-KLU");
  list.set("coarse: max size", 1000);
  return list;
}

class TrilinosNewton : public NewtonSolver {
public:
  TrilinosNewton(const Equilibrium& equations, LinearSolver solver) : solver_(solver) {
    const Body& body = equations.body();
    for (NodeVector* vector : {&residual_, &step_, &trial_})
      body.initialize(*vector);
    const IndexSet& owned = residual_.locally_owned_elements();
    const DynamicSparsityPattern nodes = equations.node_pattern();
    DynamicSparsityPattern components(owned.size(), owned.size(), owned);
    std::vector<types::global_dof_index> columns;
    for (unsigned node = 0; node < body.n_owned_nodes(); ++node) {
      const auto row = owned.nth_index_in_set(3 * node);
      columns.clear();
      for (auto entry = nodes.begin(row / 3); entry != nodes.end(row / 3); ++entry)
        for (unsigned c = 0; c < 3; ++c)
          columns.push_back(3 * entry->column() + c);
      for (unsigned c = 0; c < 3; ++c)
        components.add_entries(row + c, columns.begin(), columns.end(), true);
    }
    matrix_.reinit(owned, components, body.communicator(), false);
  }

  NewtonReport solve(const Equilibrium& equations, NodeVector& unknown,
                     const NewtonLimits& limits) override {
    NewtonReport report;
    if (!(equations.residual(unknown, residual_) > 0.))
      return report;
    report.residual_norm = residual_.l2_norm();
    backtracking_ = {};
    while (report.residual_norm > limits.residual_norm && report.n_steps < limits.max_steps) {
      assemble(equations, unknown);
      if (!solve_for_step(equations.body(), unknown, report) ||
          !backtrack(equations, unknown, report))
        break;
      ++report.n_steps;
    }
    report.converged = report.residual_norm <= limits.residual_norm;
    return report;
  }

private:
  void assemble(const Equilibrium& equations, const NodeVector& unknown) {
    matrix_ = 0.;
    std::vector<types::global_dof_index> columns;
    equations.tangent(unknown, [&](const auto& nodes, const auto& values) {
      columns.clear();
      for (const int node : nodes)
        for (unsigned c = 0; c < 3; ++c)
          columns.push_back(3 * static_cast<types::global_dof_index>(node) + c);
      const auto n = static_cast<types::global_dof_index>(columns.size());
      for (types::global_dof_index i = 0; i < n; ++i)
        matrix_.add(columns[i], n, columns.data(), values.data() + i * n, false);
    });
    matrix_.compress(VectorOperation::add);
  }

  /// step = K^-1 residual. @returns false if it is not finite.
  bool solve_for_step(const Body& body, const NodeVector& unknown, NewtonReport& report) {
    step_ = 0.;
    SolverControl control(max_linear_iterations, linear_tolerance * report.residual_norm);
    try {
      if (solver_ == LinearSolver::direct) {
        using Direct = TrilinosWrappers::SolverDirect;
        Direct direct(control, Direct::AdditionalData(false, "Amesos_Mumps"));
        direct.solve(matrix_, step_, residual_);
      } else {
        std::vector<double> modes = rigid_modes(body, unknown);
        TrilinosWrappers::PreconditionAMG multigrid;
        multigrid.initialize(matrix_, multigrid_parameters(modes));
        using Gmres = TrilinosWrappers::SolverGMRES;
        Gmres gmres(control, Gmres::AdditionalData(false, linear_restart));
        gmres.solve(matrix_, step_, residual_, multigrid);
      }
    } catch (const SolverControl::NoConvergence&) {
      // An inexact solution is a direction still: backtracking decides.
    } catch (const ExceptionBase&) {
      return false; // a singular tangent
    }
    report.n_linear_iterations +=
        control.last_step() == numbers::invalid_unsigned_int ? 0 : control.last_step();
    return std::isfinite(step_.l2_norm());
  }

  /// Goes along the step as far as J stays positive and the residual is acceptable.
  bool backtrack(const Equilibrium& equations, NodeVector& unknown, NewtonReport& report) {
    double norm = 0.;
    const double part = backtracking_.accepted_part(report.residual_norm, [&](double tried) {
      for (unsigned k = 0; k < trial_.locally_owned_size(); ++k)
        trial_.local_element(k) = unknown.local_element(k) - tried * step_.local_element(k);
      trial_.update_ghost_values();
      const bool valid = equations.residual(trial_, residual_) > 0.;
      return norm = valid ? residual_.l2_norm() : std::numeric_limits<double>::infinity();
    });
    if (!(part > 0.))
      return false;
    report.residual_norm = norm;
    std::copy_n(trial_.begin(), trial_.locally_owned_size(), unknown.begin());
    unknown.update_ghost_values();
    return true;
  }

  const LinearSolver solver_;
  TrilinosWrappers::SparseMatrix matrix_;
  NodeVector residual_, step_, trial_;
  Backtracking backtracking_;
};

} // namespace

std::unique_ptr<NewtonSolver> make_trilinos_newton(const Equilibrium& equations,
                                                   LinearSolver solver) {
  return std::make_unique<TrilinosNewton>(equations, solver);
}

} // namespace prosup::mechanics
