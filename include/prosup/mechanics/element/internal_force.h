#ifndef PROSUP_MECHANICS_INTERNAL_FORCE_H
#define PROSUP_MECHANICS_INTERNAL_FORCE_H

#include <memory>
#include <string>
#include <vector>

#include "prosup/mechanics/body/body.h"
#include "prosup/mechanics/laws/material.h"

namespace prosup::mechanics {

/// Internal nodal forces of a body in a given reference configuration, and what
/// the explicit integrator needs with them: lumped masses and a bound on the
/// stiffness. The forces are the derivatives of the energy
///   linear, quadratic: sum_e sum_q w_q det D_q W(F_q),
///   nodal pressure: sum_e V_e W_d(F_e) + sum_a V_a U(J_a; lambda_a),
/// with W = W_d + U the law's energy of distortion and of volume, and
/// V_a = sum_e V_e/4, V_a J_a = sum_e V_e J_e/4 and V_a lambda_a =
/// sum_e V_e lambda_e/4 over the elements e at node a: volume changes averaged
/// at the nodes (Joldes, Wittek, Miller 2009; Bonet, Burton 1998).
class InternalForce {
public:
  explicit InternalForce(const Body& body);
  ~InternalForce();
  InternalForce(const InternalForce&) = delete;
  InternalForce& operator=(const InternalForce&) = delete;

  void set_material(const Material& material);

  /// Makes `reference` (positions X with ghosts, mm) the stress-free state.
  /// Collective.
  /// @returns the smallest volume of an element on this rank, mm^3 (at the worst
  /// point of a quadratic one); not positive if the configuration is inverted.
  double set_reference(const NodeVector& reference);

  /// Subtracts the internal forces at the displacement u = x - X from `force`
  /// (owned nodes, g mm/s^2). Collective: brings the ghosts of `displacement` up
  /// to date and adds what other ranks have for the nodes of this one, while the
  /// elements within the rank are computed.
  /// @returns the smallest J = det F on this rank.
  double subtract(const NodeVector& displacement, NodeVector& force) const;

  /// int N_a dV over the reference configuration at the local nodes, mm^3: what
  /// a force per volume gives to the nodes. Negative at the corners of quadratic
  /// elements. Collective.
  std::vector<double> nodal_volume() const;

  /// The reference volume lumped to the local nodes for the mass, mm^3: a quarter
  /// of a linear element at each corner; 1/36 at the corners and 4/27 at the
  /// edges of a quadratic one (HRZ: in proportion to the diagonal of the
  /// consistent mass). Collective.
  std::vector<double> lumped_volume() const;

  /// Bound on the stiffness at the local nodes for the given displacement, g/s^2:
  /// the norms of the blocks in a row of the elements' tangents, summed. With masses
  /// m_a all eigenfrequencies satisfy omega^2 <= max_a k_a / m_a (Gershgorin).
  /// Collective.
  std::vector<double> stiffness_bound(const NodeVector& displacement) const;

  /// The element of this rank with the smallest J at a quadrature point.
  struct WorstCell {
    double jacobian;             ///< J; the largest number there is if none of the rank's is finite
    unsigned cell;               ///< its index in the mesh
    dealii::Tensor<1, 3> centre; ///< in the configuration `positions`, mm
  };
  WorstCell worst_cell(const NodeVector& positions, const NodeVector& displacement) const;

private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

} // namespace prosup::mechanics

#endif
