#ifndef PROSUP_MECHANICS_UNLOADED_RESPONSE_H
#define PROSUP_MECHANICS_UNLOADED_RESPONSE_H

#include <memory>

#include "prosup/mechanics/body/body.h"
#include "prosup/mechanics/body/supports.h"
#include "prosup/mechanics/laws/material.h"

namespace prosup::mechanics {

/// How the unloaded positions X of a body follow its forces while the loaded positions x stay. In
/// balance
///   F(X) = external(X) - internal(X -> x) - springs(X -> x)
/// is normal to the surfaces on which nodes slide at x, and 0 elsewhere. If something else changes
/// F by dF, X follows by
///   dX = (-dF/dX)^-1 dF,
/// tangential to these surfaces at X. The matrix is not symmetric; GMRES with the multigrid method
/// GAMG solves it. With averaged pressure, which couples each node to all around its neighbours,
/// multigrid is set up for the pressure of single elements. All functions are collective on the
/// communicator of the body.
class UnloadedResponse {
public:
  /// Whether the supports of a body allow it: nodes that may lift off a surface, or approach it
  /// gradually, have no such matrix. Local.
  static bool applies_to(const Supports& supports);

  /// At the unloaded positions `unloaded` (mm) of a body whose loaded positions are
  /// those of its mesh, with the stiffness that its supports have, and the body force (rho g,
  /// g/(mm^2 s^2)). @throws Error if PETSc fails.
  UnloadedResponse(const Supports& supports, const Material& material,
                   const dealii::Tensor<1, 3>& body_force, const NodeVector& unloaded);
  ~UnloadedResponse();

  /// dX (mm, with ghosts) for dF = `force` (owned nodes, g mm/s^2). The norm of what is left of
  /// the equations is at most `tolerance` times that of dF.
  /// @throws Error if GMRES does not converge.
  NodeVector to(const NodeVector& force, double tolerance) const;

  /// Norm of what of the force F (owned nodes) is out of balance, g mm/s^2.
  double imbalance(const NodeVector& force) const;

private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

} // namespace prosup::mechanics

#endif
