#ifndef PROSUP_MECHANICS_QUASI_STATIC_H
#define PROSUP_MECHANICS_QUASI_STATIC_H

#include <deal.II/base/parameter_acceptor.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "prosup/core/log.h"
#include "prosup/mechanics/body/body.h"
#include "prosup/mechanics/body/nodal_force.h"
#include "prosup/mechanics/laws/material.h"

namespace prosup::mechanics {

/// Names of the linear algebra in parameters: petsc-direct (SNES, MUMPS), petsc-gamg (SNES,
/// GMRES with GAMG), trilinos-direct (Amesos), trilinos-amg (ML). Both multigrid methods are given
/// the rigid body modes.
const std::vector<std::string>& linear_algebra_names();

/// Parameters of Newton's method, section "Quasi-static".
class QuasiStaticParameters : public dealii::ParameterAcceptor {
public:
  QuasiStaticParameters();
  void declare_parameters(dealii::ParameterHandler& prm) override;

  std::string linear_algebra;   ///< of linear_algebra_names()
  double tolerance = 1e-8;      ///< of the residual, over the norm of the external force
  unsigned max_iterations = 30; ///< Newton steps in one load step
  unsigned load_steps = 1;      ///< number of load steps to begin with
  unsigned max_halvings = 8;    ///< of the load step, when a step fails
};

/// Result of a quasi-static solution.
struct QuasiStaticResult {
  bool converged = false;
  unsigned n_load_steps = 0;
  unsigned n_newton_steps = 0;
  unsigned n_linear_iterations = 0;
  double residual = 0.;     ///< relative
  double min_jacobian = 0.; ///< smallest J = det dx/dX over all quadrature points
};

/// Newton's method with the consistent tangent of the discrete forces of InternalForce. It finds
/// the equilibrium of a body under a body force (constant per reference volume, rho g) and nodal
/// forces. All functions are collective on the communicator of the body.
class QuasiStatic {
public:
  QuasiStatic(const QuasiStaticParameters& parameters, const Body& body, const Log& log = Log());
  ~QuasiStatic();

  void set_material(const Material& material);
  /// Local nodes that keep their position in load() and unload().
  void set_fixed_nodes(const std::vector<bool>& fixed);
  /// rho g, g/(mm^2 s^2).
  void set_body_force(const dealii::Tensor<1, 3>& force_density) { body_force_ = force_density; }
  /// Constant nodal forces (owned nodes, g mm/s^2) in addition to the body force.
  void set_external_force(const NodeVector& force);
  /// Sets a nodal force that depends on the positions; null for none. It has to live as long as
  /// this object.
  void set_nodal_force(const NodalForce* force) { nodal_force_ = force; }

  /// Forward problem: finds u with
  ///   internal(X -> X + u) = external
  /// for the unloaded positions X. `displacement` is the start value on entry and the result, with
  /// ghosts, on return. At fixed nodes it keeps its values, which need not be zero.
  /// @throws DivergenceError with a diagnosis if no load step is small enough.
  QuasiStaticResult load(const NodeVector& unloaded, NodeVector& displacement);

  /// Inverse problem: finds X with internal(X -> x) = external for the loaded positions x, with
  /// the weight of X (Govindjee and Mihalic 1996). `unloaded` is the start value on entry and the
  /// result, with ghosts, on return. @throws DivergenceError as load().
  QuasiStaticResult unload(const NodeVector& loaded, NodeVector& unloaded);

private:
  struct Implementation;

  /// Solves for `unknown` in load steps, from its value on entry. On return or when it throws,
  /// `unknown` is the last converged state; `save` is called before.
  QuasiStaticResult solve(NodeVector& unknown, const std::function<void()>& save);
  std::string diagnosis(double reached, double tried, double min_jacobian, double residual) const;

  const QuasiStaticParameters& parameters_;
  const Body& body_;
  const Log log_;
  dealii::Tensor<1, 3> body_force_;
  const NodalForce* nodal_force_ = nullptr;
  std::unique_ptr<Implementation> implementation_;
};

} // namespace prosup::mechanics

#endif
