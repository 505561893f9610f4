#ifndef PROSUP_SRC_UNLOADING_COLLAPSE_WATCH_H
#define PROSUP_SRC_UNLOADING_COLLAPSE_WATCH_H

#include <string>

#include "prosup/mechanics/body/body.h"
#include "prosup/mechanics/element/internal_force.h"

namespace prosup::unloading {

/// Remembers the first element that collapses in a block of time steps.
class CollapseWatch {
public:
  /// Keeps references.
  CollapseWatch(const mechanics::Body& body, const mechanics::InternalForce& internal_force)
      : body_(body), internal_force_(internal_force) {}

  /// A new block begins.
  void restart();
  /// Takes this rank's smallest J before a step. Not collective.
  void look(double min_jacobian, const mechanics::NodeVector& displacement);

  /// Smallest J of the block on this rank.
  double min_jacobian() const { return min_jacobian_; }
  /// "cell 7 near (1.0, 2.0, 3.0) mm with J = 0.01": the first element of all ranks that
  /// collapsed in this block or, if none did, the one that has the smallest J now; with
  /// its place in the loaded mesh. Collective.
  std::string worst_cell(const mechanics::NodeVector& displacement) const;

private:
  const mechanics::Body& body_;
  const mechanics::InternalForce& internal_force_;
  unsigned n_steps_ = 0, first_collapse_ = 0;
  double min_jacobian_ = 1.;
  std::string collapsed_cell_;
};

} // namespace prosup::unloading

#endif
