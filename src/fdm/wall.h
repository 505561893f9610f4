#ifndef PROSUP_SRC_FDM_WALL_H
#define PROSUP_SRC_FDM_WALL_H

#include <vector>

#include "dynamics.h"
#include "slab.h"

namespace prosup::fdm {

/// A surface with u = 0 that need not go through nodes. Nodes beyond it, or nearer to
/// it than h/2, are led: with d the distance from the wall, negative beyond, they take
/// u = d s, where s = sum(d u)/sum(d^2) over the neighbours that are free is the best fit
/// of displacements that vanish on the wall. To hold the first nodes beyond it instead
/// would move the wall by half a cell, and by as much from one grid to the next.
class Wall {
public:
  /// From the distance of each local node, mm.
  Wall(const Slab& slab, const std::vector<float>& distance);

  bool leads(std::size_t node) const { return leads_[node]; }
  /// Gives the led nodes their displacements, on all ranks.
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
