#ifndef PROSUP_MECHANICS_EQUILIBRIUM_H
#define PROSUP_MECHANICS_EQUILIBRIUM_H

#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <array>
#include <functional>
#include <vector>

#include "mechanics/element/element_tangent.h"
#include "prosup/mechanics/static/quasi_static.h"

namespace prosup::mechanics {

class NodalPressure;

/// Which positions are unknown; the others are given.
enum class Unknown { loaded, unloaded };

/// The equations of equilibrium of a body at its free nodes,
///   internal(X, x) - external(X, x) = 0,
/// with either X or x unknown, and their derivative with respect to it. Positions include
/// ghosts. Independent of the linear algebra.
class Equilibrium {
public:
  /// Adds a dense block, stored row by row, at the components of nodes with
  /// these global numbers.
  using AddBlock =
      std::function<void(const std::vector<int>& nodes, const std::vector<double>& values)>;

  /// Takes a dense block u w^T of components of nodes with these global numbers.
  using AddProduct =
      std::function<void(const std::vector<int>& nodes, const std::vector<dealii::Tensor<1, 3>>& u,
                         const std::vector<dealii::Tensor<1, 3>>& w)>;

  explicit Equilibrium(const Body& body);

  const Body& body() const { return body_; }

  /// @throws Error if the material is not uniform and has not one entry per element.
  void set_material(const Material& material);
  void set_fixed_nodes(const std::vector<bool>& fixed) { fixed_ = fixed; }
  void set_nodal_force(const NodalForce* force) { nodal_force_ = force; }
  /// Body force b per unloaded volume (g/(mm^2 s^2)) and constant nodal forces (g mm/s^2).
  void set_external_force(const dealii::Tensor<1, 3>& body_force, const NodeVector& nodal);
  /// `known` has to live as long as the problem.
  void set_problem(Unknown unknown, const NodeVector& known);
  /// Fraction of the external force that acts. The nodal force that depends on the positions
  /// acts in full.
  void set_load_fraction(double fraction) { load_fraction_ = fraction; }

  /// @throws Error if there is no material or nothing holds the body. Collective.
  void check() const;

  /// Norm of the full external force at free nodes, g mm/s^2; 1 if there is none.
  double external_force_norm(const NodeVector& unknown) const;

  /// Writes the residual at owned nodes, 0 at fixed ones, g mm/s^2. Collective.
  /// @returns the smallest J of all ranks; if it is not positive, the residual is not valid.
  double residual(const NodeVector& unknown, NodeVector& residual) const;

  /// Adds the derivative of the residual block by block, with 1 on the diagonal at fixed
  /// components. All J have to be positive. Collective.
  void tangent(const NodeVector& unknown, const AddBlock& add) const;

  /// The same, with what couples all nodes around another one (the averaged pressure of each owned
  /// node) as products.
  void tangent(const NodeVector& unknown, const AddBlock& add, const AddProduct& add_product) const;

  /// Takes the pressure of each element for itself, where it is averaged at nodes: a tangent that
  /// couples neighbours only, to precondition the other one.
  void take_local_pressure() { takes_local_pressure_ = true; }

  /// Pairs of nodes that the tangent couples, in the rows of owned nodes, with or without the
  /// products. Collective.
  dealii::DynamicSparsityPattern node_pattern(bool with_products = true) const;

private:
  const NodeVector& unloaded(const NodeVector& unknown) const {
    return unknown_ == Unknown::unloaded ? unknown : *known_;
  }
  const NodeVector& loaded(const NodeVector& unknown) const {
    return unknown_ == Unknown::loaded ? unknown : *known_;
  }
  bool averages_pressure() const {
    return body_.element().type == ElementType::nodal_pressure && !takes_local_pressure_;
  }
  template <typename L>
  PointResponse point_response(const L& law, unsigned element, const PointKinematics& point) const {
    return averages_pressure()
               ? distortion_response(law, material_[element], point.F, point.jacobian)
               : response(law, material_[element], point.F, point.jacobian);
  }
  /// Returns the smallest J, not positive as soon as an element is inverted.
  template <typename L>
  double add_element_forces(const L& law, const NodeVector& unknown, NodeVector& force) const;
  template <typename L>
  void add_element_tangents(const L& law, const NodeVector& unknown, const NodalPressure* pressure,
                            const AddBlock& add) const;
  void add_nodal_tangents(const NodeVector& unknown, const AddBlock& add) const;
  void add_external_force(const NodeVector& unknown, double factor, NodeVector& force) const;
  void add_skin_forces(const NodeVector& unknown, NodeVector& force) const;
  void add_skin_tangents(const NodeVector& unknown, const AddBlock& add) const;
  int global_node(unsigned local_node) const;

  const Body& body_;
  const ElementShape& shape_;
  Material material_;
  std::vector<std::array<unsigned, 3>> skin_; // membrane_triangles()
  std::vector<bool> fixed_;
  dealii::Tensor<1, 3> body_force_;
  NodeVector nodal_load_;
  const NodalForce* nodal_force_ = nullptr;
  Unknown unknown_ = Unknown::loaded;
  const NodeVector* known_ = nullptr;
  double load_fraction_ = 1.;
  bool takes_local_pressure_ = false;
};

} // namespace prosup::mechanics

#endif
