#ifndef PROSUP_SRC_FDM_WALL_H
#define PROSUP_SRC_FDM_WALL_H

#include <vector>

#include "dynamics.h"
#include "slab.h"

namespace prosup::fdm {

/// A surface with u = 0 that does not have to pass through nodes. Nodes beyond it, or nearer
/// to it than h/2, are led: with the distance d from the wall, negative beyond it, they get
/// u = d s. The slope s = sum(d u)/sum(d^2) over their free neighbours is the best fit of a
/// displacement that vanishes on the wall. Fixing the first nodes beyond the wall instead
/// would shift it by up to half a cell, differently on each grid.
class Wall {
public:
  /// `distance`: of each local node from the wall, mm.
  Wall(const Slab& slab, const std::vector<float>& distance);

  bool leads(std::size_t node) const { return leads_[node]; }
  /// Sets the displacements of the led nodes, on all ranks.
  void lead(Dynamics& dynamics) const;

private:
  const Slab& slab_;
  std::vector<bool> leads_;
  std::vector<std::size_t> led_;   ///< nodes with free neighbours
  std::vector<std::size_t> first_; ///< of the entries of each, and the end
  std::vector<std::size_t> neighbours_;
  std::vector<Real> weights_;
};

} // namespace prosup::fdm

#endif
