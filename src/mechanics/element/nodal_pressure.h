#ifndef PROSUP_MECHANICS_NODAL_PRESSURE_H
#define PROSUP_MECHANICS_NODAL_PRESSURE_H

#include <vector>

#include "element_tangent.h"

namespace prosup::mechanics {

/// Positions of the nodes of an element.
ElementVector element_positions(const Body& body, unsigned element, const NodeVector& positions);

/// Volume changes averaged at the nodes: with the shares of the elements at
/// node a of their unloaded and loaded volumes, V_a = sum_e V_e/4 and
/// v_a = sum_e v_e/4, the volumetric energy of the body is
///   sum_a V_a lambda_a/2 (ln J_a)^2,  J_a = v_a/V_a,  lambda_a = sum_e V_e lambda_e/4 / V_a,
/// hence the pressure of a node p_a = lambda_a ln J_a / J_a, that of an element
/// the mean over its nodes, and its nodal forces p_e dv_e/dx.
class NodalPressure {
public:
  explicit NodalPressure(const Body& body);

  /// Sets the state; positions with ghosts, no inverted element. Collective.
  void evaluate(const std::vector<LameParameters>& material, const NodeVector& unloaded,
                const NodeVector& loaded);

  /// p_e, Pa.
  double element_pressure(unsigned element) const;

  /// The pressures' share of the tangent, dv_a/dx (x) dp_a/dy, for an owned
  /// node: its factors at all nodes (global numbers) of the elements around it.
  struct Patch {
    std::vector<int> nodes;
    std::vector<dealii::Tensor<1, 3>> volume_change;   ///< dv_a/dx, mm^2
    std::vector<dealii::Tensor<1, 3>> pressure_change; ///< dp_a/dy, Pa/mm
  };

  /// The patches of the owned nodes, with derivatives of pressures by the
  /// loaded or the unloaded positions and zeros at `fixed` nodes. Collective.
  std::vector<Patch> patches(bool by_loaded, const std::vector<bool>& fixed) const;

private:
  struct Node {
    double unloaded_volume, jacobian, lambda, pressure;
  };
  Node node(unsigned local_node) const;
  /// dp_a/dv_e where `by_loaded`, or dp_a/dV_e, times 4.
  static double pressure_by_volume(const Node& node, double element_lambda, bool by_loaded);

  const Body& body_;
  const std::vector<LameParameters>* material_ = nullptr;
  const NodeVector* unloaded_ = nullptr;
  const NodeVector* loaded_ = nullptr;
  NodeVector sums_; // per node V_a, v_a, sum_e V_e lambda_e/4
};

} // namespace prosup::mechanics

#endif
