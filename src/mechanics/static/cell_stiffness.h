#ifndef PROSUP_SRC_MECHANICS_CELL_STIFFNESS_H
#define PROSUP_SRC_MECHANICS_CELL_STIFFNESS_H

#include <array>
#include <cmath>
#include <variant>

#include "mechanics/element/point_response.h"
#include "prosup/mechanics/body/body.h"
#include "prosup/mechanics/body/cell_edges.h"

namespace prosup::mechanics {

/// Gradients of the barycentric coordinates of a cell and its volume.
struct CellShape {
  std::array<dealii::Tensor<1, 3>, 4> gradient; ///< 1/mm
  double volume;                                ///< mm^3

  CellShape(const std::array<unsigned, 4>& nodes, const NodeVector& positions) {
    const dealii::Tensor<2, 3> edges = cell_edges(nodes, positions);
    volume = std::abs(determinant(edges)) / 6.;
    const dealii::Tensor<2, 3> inverse = invert(edges);
    gradient[0] = dealii::Tensor<1, 3>();
    for (unsigned b = 0; b < 3; ++b) {
      gradient[b + 1] = inverse[b];
      gradient[0] -= inverse[b];
    }
  }
};

/// The stiffness of one of Body::cells() at rest, block 4 a + b for its corners a and b.
using CellBlocks = std::array<dealii::Tensor<2, 3>, 16>;

/// Calls `visit(cell, blocks)` with the stiffness of each linear cell of this rank, at rest at
/// `unloaded` (mm, with ghosts). It is the tangent of element_tangent.h at F = 1, where
/// h_a = g_a = G_a:
///   k_ab = V [a g_a.g_b I + (aa + 2 ab + bb) g_a g_b^T - b g_b g_a^T].
template <typename Visit>
void for_each_cell_stiffness(const Body& body, const Material& material, const NodeVector& unloaded,
                             const Visit& visit) {
  using dealii::Tensor;
  const Tensor<2, 3> identity = dealii::unit_symmetric_tensor<3>();
  const unsigned n_per_element = body.element().n_cells();
  const auto add = [&](const auto& law) {
    CellBlocks blocks;
    for (unsigned cell = 0; cell < body.cells().size(); ++cell) {
      const CellShape shape(body.cells()[cell], unloaded);
      const PointResponse at_rest = response(law, material[cell / n_per_element], identity, 1.);
      const auto& [aa, ab, bb] = at_rest.tangent;
      for (unsigned a = 0; a < 4; ++a)
        for (unsigned b = 0; b < 4; ++b) {
          const auto &g = shape.gradient[a], &h = shape.gradient[b];
          blocks[4 * a + b] = shape.volume * (at_rest.stress.a * (g * h) * identity -
                                              at_rest.stress.b * outer_product(h, g) +
                                              (aa + 2. * ab + bb) * outer_product(g, h));
        }
      visit(cell, blocks);
    }
  };
  std::visit(add, material.law());
}

} // namespace prosup::mechanics

#endif
