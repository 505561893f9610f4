#ifndef PROSUP_MECHANICS_NODAL_PRESSURE_H
#define PROSUP_MECHANICS_NODAL_PRESSURE_H

#include <vector>

#include "element_tangent.h"

namespace prosup::mechanics {

/// Positions of the nodes of an element.
ElementVector element_positions(const Body& body, unsigned element, const NodeVector& positions);

/// Volume changes averaged at the nodes. The elements at node a share their unloaded and loaded
/// volumes, V_a = sum_e V_e/4 and v_a = sum_e v_e/4. With U the volumetric part of the law, the
/// volumetric energy of the body is
///   sum_a V_a U(J_a; lambda_a),  J_a = v_a/V_a,  lambda_a = sum_e V_e lambda_e/4 / V_a.
/// Hence the pressure of a node is p_a = dU/dJ, that of an element p_e the mean over its nodes,
/// and the nodal forces are p_e dv_e/dx.
class NodalPressure {
public:
  explicit NodalPressure(const Body& body);

  /// Sets the state: positions with ghosts and without inverted elements. The arguments have to
  /// live as long as this object is used. Collective.
  void evaluate(const Material& material, const NodeVector& unloaded, const NodeVector& loaded);

  /// p_e, Pa.
  double element_pressure(unsigned element) const;

  /// The part of the tangent that comes from the pressure of one node, dv_a/dx (x) dp_a/dy: its
  /// two factors at all nodes (global numbers) of the elements around the node.
  struct Patch {
    std::vector<int> nodes;
    std::vector<dealii::Tensor<1, 3>> volume_change;   ///< dv_a/dx, mm^2
    std::vector<dealii::Tensor<1, 3>> pressure_change; ///< dp_a/dy, Pa/mm
  };

  /// The patches of the owned nodes, with derivatives of the pressures with respect to the loaded
  /// or the unloaded positions, and zeros at `fixed` nodes. Collective.
  std::vector<Patch> patches(bool by_loaded, const std::vector<bool>& fixed) const;

private:
  struct Node {
    double unloaded_volume, jacobian, lambda;
    double pressure;    ///< dU/dJ, Pa
    double by_jacobian; ///< dp/dJ, Pa
    double by_lambda;   ///< dp/dlambda; U is proportional to lambda
  };
  template <typename L>
  void evaluate_nodes(const L& law);
  /// dp_a/dv_e where `by_loaded`, or dp_a/dV_e, times 4.
  static double pressure_by_volume(const Node& node, double element_lambda, bool by_loaded);

  const Body& body_;
  const Material* material_ = nullptr;
  const NodeVector* unloaded_ = nullptr;
  const NodeVector* loaded_ = nullptr;
  NodeVector sums_;         // of each node V_a, v_a, sum_e V_e lambda_e/4
  std::vector<Node> nodes_; // local
};

} // namespace prosup::mechanics

#endif
