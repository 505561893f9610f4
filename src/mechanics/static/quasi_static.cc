#include "prosup/mechanics/static/quasi_static.h"

#include <algorithm>

#include "newton.h"
#include "prosup/core/error.h"

namespace prosup::mechanics {

using namespace dealii;

struct QuasiStatic::Implementation {
  explicit Implementation(const Body& body) : equations(body) {
    body.initialize(external_force);
    body.initialize(residual);
  }

  Equilibrium equations;
  NodeVector external_force, residual;
  std::unique_ptr<NewtonSolver> newton;
};

namespace {

std::unique_ptr<NewtonSolver> make_newton(const std::string& name, const Equilibrium& equations) {
  const auto& names = linear_algebra_names();
  if (std::find(names.begin(), names.end(), name) == names.end()) {
    std::string list;
    for (const std::string& allowed : names)
      list += (list.empty() ? "" : ", ") + allowed;
    throw Error("'Quasi-static/Linear algebra' is '" + name + "'; allowed are " + list + ".");
  }
  const bool direct = name.find("-direct") != std::string::npos;
  const LinearSolver solver = direct ? LinearSolver::direct : LinearSolver::multigrid;
  return name.rfind("petsc", 0) == 0 ? make_petsc_newton(equations, solver)
                                     : make_trilinos_newton(equations, solver);
}

void copy_owned(const NodeVector& from, NodeVector& to) {
  std::copy_n(from.begin(), from.locally_owned_size(), to.begin());
  to.update_ghost_values();
}

} // namespace

QuasiStatic::QuasiStatic(const QuasiStaticParameters& parameters, const Body& body, const Log& log)
    : parameters_(parameters), body_(body), log_(log),
      implementation_(std::make_unique<Implementation>(body)) {}

QuasiStatic::~QuasiStatic() = default;

void QuasiStatic::set_material(const Material& material) {
  implementation_->equations.set_material(material);
}

void QuasiStatic::set_fixed_nodes(const std::vector<bool>& fixed) {
  implementation_->equations.set_fixed_nodes(fixed);
}

void QuasiStatic::set_external_force(const NodeVector& force) {
  std::copy_n(force.begin(), 3 * body_.n_owned_nodes(), implementation_->external_force.begin());
}

QuasiStaticResult QuasiStatic::load(const NodeVector& unloaded, NodeVector& displacement) {
  NodeVector X, x;
  for (NodeVector* positions : {&X, &x})
    body_.initialize(*positions);
  copy_owned(unloaded, X);
  copy_owned(X, x);
  x.add(1., displacement);
  x.update_ghost_values();
  implementation_->equations.set_problem(Unknown::loaded, X);
  const auto set_displacement = [&] {
    for (unsigned i = 0; i < x.locally_owned_size(); ++i)
      displacement.local_element(i) = x.local_element(i) - X.local_element(i);
    displacement.update_ghost_values();
  };
  return solve(x, set_displacement);
}

QuasiStaticResult QuasiStatic::unload(const NodeVector& loaded, NodeVector& unloaded) {
  NodeVector x;
  body_.initialize(x);
  copy_owned(loaded, x);
  unloaded.update_ghost_values();
  implementation_->equations.set_problem(Unknown::unloaded, x);
  return solve(unloaded, [] {});
}

QuasiStaticResult QuasiStatic::solve(NodeVector& unknown, const std::function<void()>& save) {
  Equilibrium& equations = implementation_->equations;
  equations.set_nodal_force(nodal_force_);
  equations.check();
  equations.set_external_force(body_force_, implementation_->external_force);
  if (!implementation_->newton)
    implementation_->newton = make_newton(parameters_.linear_algebra, equations);
  const double force_norm = equations.external_force_norm(unknown);
  const NewtonLimits limits{parameters_.tolerance * force_norm, parameters_.max_iterations};

  NodeVector last_good = unknown;
  QuasiStaticResult result;
  double reached = 0., step = 1. / parameters_.load_steps;
  unsigned n_halvings = 0;
  while (reached < 1.) {
    const double fraction = reached + step > 1. - 1e-9 ? 1. : reached + step;
    equations.set_load_fraction(fraction);
    const NewtonReport report = implementation_->newton->solve(equations, unknown, limits);
    result.n_newton_steps += report.n_steps;
    result.n_linear_iterations += report.n_linear_iterations;
    result.residual = report.residual_norm / force_norm;
    log_.progress(format("  load %.3f: %u Newton steps, residual %.1e", fraction, report.n_steps,
                         result.residual));
    if (report.converged) {
      ++result.n_load_steps;
      reached = fraction;
      copy_owned(unknown, last_good);
      continue;
    }
    const double min_jacobian = equations.residual(unknown, implementation_->residual);
    copy_owned(last_good, unknown);
    if (n_halvings++ == parameters_.max_halvings) {
      save();
      throw DivergenceError(diagnosis(reached, fraction, min_jacobian, result.residual));
    }
    step *= 0.5;
  }
  result.min_jacobian = equations.residual(unknown, implementation_->residual);
  result.converged = true;
  save();
  return result;
}

std::string QuasiStatic::diagnosis(double reached, double tried, double min_jacobian,
                                   double residual) const {
  return format("The quasi-static solver found no equilibrium beyond %.4g of the load (at %.4g the "
                "residual stayed at %.2g of the external force and the smallest J at %.3g) after "
                "%u halvings of the load step; stiffen the material, reduce the load or allow more "
                "in 'Quasi-static/Maximum halvings'.",
                reached, tried, std::min(residual, 1e30), min_jacobian, parameters_.max_halvings);
}

} // namespace prosup::mechanics
