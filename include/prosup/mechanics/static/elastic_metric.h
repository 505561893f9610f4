#ifndef PROSUP_MECHANICS_ELASTIC_METRIC_H
#define PROSUP_MECHANICS_ELASTIC_METRIC_H

#include <deal.II/base/symmetric_tensor.h>

#include <array>
#include <cstdint>
#include <vector>

#include "prosup/mechanics/body/body.h"
#include "prosup/mechanics/body/supports.h"
#include "prosup/mechanics/laws/material.h"

namespace prosup::mechanics {

/// A symmetric stiffness of one of Body::cells(), such as the sum over voxels v of
/// N_a(X_v) N_b(X_v) S_v: one symmetric block for each pair a <= b of its corners, in
/// the order 00, 01, 02, 03, 11, 12, 13, 22, 23, 33.
using CellStiffness = std::array<dealii::SymmetricTensor<2, 3>, 10>;

/// The stiffness K of a body at rest in a configuration X (the tangent of its law) and of
/// the springs of its supports, for displacements that the supports allow. d^T K d
/// measures the distance of a configuration X + d from X. The elements are linear
/// tetrahedra on Body::cells(). Other stiffness can be added to that of the elements. All
/// functions are collective on the communicator of the body; vectors hold owned nodes.
class ElasticMetric {
public:
  /// `unloaded` is X with ghosts, mm,
  /// on the surfaces of the supports (Supports::put_on_surfaces).
  ElasticMetric(const Supports& supports, const Material& material, const NodeVector& unloaded);

  /// K v, projected to what the supports allow, g mm/s^2.
  void multiply(const NodeVector& v, NodeVector& result) const;

  /// Solves (K + factor H) d = f in the space of allowed displacements by conjugate
  /// gradients, until the residual is below `tolerance` |f|. H is the sum of `added`, the
  /// stiffness of each cell of this rank. Returns the number of iterations.
  unsigned solve(const std::vector<CellStiffness>& added, double factor, const NodeVector& force,
                 double tolerance, NodeVector& displacement) const;

private:
  using Block = dealii::Tensor<2, 3>;
  class Operator;

  void list_couplings();
  void add_elements(const Material& material, const NodeVector& unloaded);
  void add_skin(const Skin& skin, const NodeVector& unloaded);
  std::uint32_t slot_of(unsigned row, unsigned column) const; // of local nodes that are coupled
  void multiply(const std::vector<Block>& blocks, const NodeVector& v, NodeVector& result) const;
  std::vector<Block> inverse_diagonal(const std::vector<Block>& blocks) const;

  const Supports& supports_;
  const Body& body_;
  // Rows of all local nodes, as far as the cells of this rank fill them.
  std::vector<std::uint32_t> row_begin_, column_;
  std::vector<std::array<std::uint32_t, 16>> slots_; // of each cell's blocks, row by row
  std::vector<Block> blocks_;
};

} // namespace prosup::mechanics

#endif
