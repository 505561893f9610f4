#ifndef PROSUP_TESTS_BOX_OF_TETS_H
#define PROSUP_TESTS_BOX_OF_TETS_H

#include <random>

#include "prosup/mesh/tet_mesh.h"

namespace prosup::tests {

/// The box [low, high] cut into n^3 bricks of six tetrahedra each; inner nodes
/// are moved at random by up to `jitter` brick lengths, so that no face lies in
/// a coordinate plane. Tissue is 2 (fat) and 3 (gland) by turns.
inline mesh::TetMesh box_of_tets(const dealii::Point<3>& low, const dealii::Point<3>& high,
                                 unsigned n, double jitter = 0.15) {
  mesh::TetMesh box;
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> random(-jitter, jitter);
  const auto inside = [n](unsigned i) { return i > 0 && i < n; };
  for (unsigned k = 0; k <= n; ++k)
    for (unsigned j = 0; j <= n; ++j)
      for (unsigned i = 0; i <= n; ++i) {
        dealii::Point<3> q(i, j, k);
        if (inside(i) && inside(j) && inside(k))
          for (unsigned d = 0; d < 3; ++d)
            q[d] += random(generator);
        for (unsigned d = 0; d < 3; ++d)
          q[d] = low[d] + (high[d] - low[d]) * q[d] / n;
        box.points.push_back(q);
      }
  const unsigned stride[3] = {1, n + 1, (n + 1) * (n + 1)};
  const unsigned paths[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
  for (unsigned k = 0; k < n; ++k)
    for (unsigned j = 0; j < n; ++j)
      for (unsigned i = 0; i < n; ++i)
        for (unsigned p = 0; p < 6; ++p) {
          std::array<unsigned, 4> cell{i * stride[0] + j * stride[1] + k * stride[2], 0, 0, 0};
          for (unsigned a = 0; a < 3; ++a)
            cell[a + 1] = cell[a] + stride[paths[p][a]];
          if (p >= 3) // the odd permutations of the axes are mirrored
            std::swap(cell[2], cell[3]);
          box.cells.push_back(cell);
          box.tissue.push_back(box.cells.size() % 2 == 0 ? 2 : 3);
        }
  return box;
}

} // namespace prosup::tests

#endif
