#ifndef PROSUP_MECHANICS_CELL_EDGES_H
#define PROSUP_MECHANICS_CELL_EDGES_H

#include <array>

#include "prosup/mechanics/body/body.h"

namespace prosup::mechanics {

/// Columns are the edges of a linear tetrahedron (local node numbers, as of
/// Body::cells()) from its first corner, mm. The determinant is six times its signed
/// volume; two configurations give F = edges(x) edges(X)^-1.
inline dealii::Tensor<2, 3> cell_edges(const std::array<unsigned, 4>& cell,
                                       const NodeVector& positions) {
  dealii::Tensor<2, 3> edges;
  for (unsigned b = 0; b < 3; ++b) {
    const dealii::Tensor<1, 3> edge =
        node_value(positions, cell[b + 1]) - node_value(positions, cell[0]);
    for (unsigned c = 0; c < 3; ++c)
      edges[c][b] = edge[c];
  }
  return edges;
}

} // namespace prosup::mechanics

#endif
