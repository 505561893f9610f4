#ifndef PROSUP_MECHANICS_INTERNAL_FORCE_H
#define PROSUP_MECHANICS_INTERNAL_FORCE_H

#include <string>
#include <vector>

#include "prosup/mechanics/body.h"
#include "prosup/mechanics/material.h"

namespace prosup::mechanics {

/// Internal nodal forces of a body of linear tetrahedra in a given reference
/// configuration, and what the explicit integrator has to know of it: lumped
/// volumes and a bound on the stiffness. Cells are kept in batches of eight.
class InternalForce {
public:
  explicit InternalForce(const Body& body);
  ~InternalForce();
  InternalForce(const InternalForce&) = delete;
  InternalForce& operator=(const InternalForce&) = delete;

  /// One entry per owned cell in the order of Body::cells(), or a single one.
  void set_material(const std::vector<LameParameters>& parameters);

  /// Makes `reference` (positions X with ghosts, mm) the stress-free state.
  /// @returns the smallest cell volume on this rank, mm^3; not positive if the
  /// configuration is inverted.
  double set_reference(const NodeVector& reference);

  /// Subtracts f_a = sum_e V_e P(F) grad N_a from `force` (g mm/s^2), for owned
  /// nodes and ghosts, without exchange between ranks (the caller compresses).
  /// `displacement` u = x - X needs its ghosts.
  /// @returns the smallest J = det F on this rank.
  double subtract(const NodeVector& displacement, NodeVector& force) const;

  /// Volume of the reference configuration lumped to the nodes: a quarter of
  /// each cell at each corner, mm^3, owned nodes and ghosts.
  std::vector<double> lumped_volume() const;

  /// Upper bound on the stiffness, lumped to the nodes, g/s^2: each cell gives
  /// each corner a bound on the largest eigenvalue of its tangent stiffness at
  /// the given displacement. With masses m_a, all eigenfrequencies satisfy
  /// omega^2 <= max_a k_a / m_a.
  std::vector<double> stiffness_bound(const NodeVector& displacement) const;

  /// Names the first cell with J <= bound on this rank: its mesh index, J and
  /// centre in the configuration `positions`; empty if there is none.
  std::string describe_worst_cell(const NodeVector& positions, const NodeVector& displacement,
                                  double bound) const;

private:
  struct Batches;

  std::vector<double> sum_to_nodes(const std::vector<double>& per_cell) const;

  const Body& body_;
  std::unique_ptr<Batches> batches_;
};

} // namespace prosup::mechanics

#endif
