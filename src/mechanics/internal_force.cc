#include "prosup/mechanics/internal_force.h"

#include <deal.II/base/aligned_vector.h>
#include <deal.II/base/symmetric_tensor.h>

#include <algorithm>
#include <cmath>

#include "element_kernel.h"
#include "prosup/core/log.h"

namespace prosup::mechanics {

using namespace dealii;
using kernel::n_lanes;

struct InternalForce::Batches {
  AlignedVector<kernel::Batch> data;
  std::size_t n_cells = 0;

  template <typename Visit>
  void for_each_cell(Visit visit) {
    for (std::size_t i = 0; i < data.size() * n_lanes; ++i)
      visit(data[i / n_lanes], i % n_lanes, std::min(i, n_cells - 1));
  }
};

namespace {

/// Gradients of the three barycentric coordinates N_1..N_3; N_0 is the rest.
Tensor<2, 3> inverse_edges(const kernel::Batch& batch, std::size_t lane) {
  Tensor<2, 3> D;
  for (unsigned b = 0; b < 3; ++b)
    for (unsigned j = 0; j < 3; ++j)
      D[b][j] = batch.inverse_edges[b][j][lane];
  return D;
}

Tensor<2, 3> deformation_gradient(const kernel::Batch& batch, std::size_t lane,
                                  const NodeVector& displacement) {
  Tensor<2, 3> edges;
  for (unsigned b = 0; b < 3; ++b)
    for (unsigned c = 0; c < 3; ++c)
      edges[c][b] = displacement.local_element(3 * batch.node[b + 1][lane] + c) -
                    displacement.local_element(3 * batch.node[0][lane] + c);
  return unit_symmetric_tensor<3>() + edges * inverse_edges(batch, lane);
}

/// Largest eigenvalue of sum_a grad N_a grad N_a^T, 1/mm^2.
double squared_gradient_norm(const Tensor<2, 3>& gradients) {
  const Tensor<1, 3> of_first = -gradients[0] - gradients[1] - gradients[2];
  Tensor<2, 3> gram = outer_product(of_first, of_first);
  for (unsigned b = 0; b < 3; ++b)
    gram += outer_product(gradients[b], gradients[b]);
  return eigenvalues(symmetrize(gram))[0];
}

/// Bound on the largest eigenvalue of a cell's tangent stiffness over its
/// volume. The tangent of P = mu F + (lambda ln J - mu) F^-T couples nodes by
///   k_ab = V [mu G_a.G_b I + lambda g_a g_b^T + (mu - lambda ln J) g_b g_a^T]
/// with G = grad_X N and g = F^-T G.
double tangent_bound(const Tensor<2, 3>& gradients, const Tensor<2, 3>& F, double mu,
                     double lambda) {
  const double J = std::max(determinant(F), 1e-3);
  const double spatial = mu - lambda * std::log(J);
  return mu * squared_gradient_norm(gradients) +
         (lambda + std::abs(spatial)) * squared_gradient_norm(gradients * invert(F));
}

} // namespace

InternalForce::InternalForce(const Body& body)
    : body_(body), batches_(std::make_unique<Batches>()) {
  batches_->n_cells = body.cells().size();
  batches_->data.resize((batches_->n_cells + n_lanes - 1) / n_lanes);
  // Padding lanes repeat the last cell; their volume stays 0.
  batches_->for_each_cell([&](kernel::Batch& batch, std::size_t lane, std::size_t cell) {
    for (unsigned a = 0; a < 4; ++a)
      batch.node[a][lane] = body.cells()[cell][a];
  });
}

InternalForce::~InternalForce() = default;

void InternalForce::set_material(const std::vector<LameParameters>& parameters) {
  batches_->for_each_cell([&](kernel::Batch& batch, std::size_t lane, std::size_t cell) {
    const LameParameters& material = parameters[parameters.size() == 1 ? 0 : cell];
    batch.mu[lane] = material.mu;
    batch.lambda[lane] = material.lambda;
  });
}

double InternalForce::set_reference(const NodeVector& reference) {
  return kernel::set_reference(batches_->data.data(), batches_->data.size(), batches_->n_cells,
                               reference.begin());
}

double InternalForce::subtract(const NodeVector& displacement, NodeVector& force) const {
  return kernel::subtract_neo_hookean(batches_->data.data(), batches_->data.size(),
                                      displacement.begin(), force.begin());
}

std::vector<double> InternalForce::sum_to_nodes(const std::vector<double>& per_cell) const {
  NodeVector sum;
  body_.initialize(sum);
  for (std::size_t cell = 0; cell < per_cell.size(); ++cell)
    for (const unsigned node : body_.cells()[cell])
      sum.local_element(3 * node) += per_cell[cell];
  sum.compress(VectorOperation::add);
  sum.update_ghost_values();
  std::vector<double> at_nodes(body_.n_local_nodes());
  for (unsigned node = 0; node < at_nodes.size(); ++node)
    at_nodes[node] = sum.local_element(3 * node);
  return at_nodes;
}

std::vector<double> InternalForce::lumped_volume() const {
  std::vector<double> quarter(batches_->n_cells);
  for (std::size_t cell = 0; cell < quarter.size(); ++cell)
    quarter[cell] = 0.25 * batches_->data[cell / n_lanes].volume[cell % n_lanes];
  return sum_to_nodes(quarter);
}

std::vector<double> InternalForce::stiffness_bound(const NodeVector& displacement) const {
  std::vector<double> bound(batches_->n_cells);
  for (std::size_t cell = 0; cell < bound.size(); ++cell) {
    const kernel::Batch& batch = batches_->data[cell / n_lanes];
    const std::size_t lane = cell % n_lanes;
    bound[cell] =
        std::abs(batch.volume[lane]) *
        tangent_bound(inverse_edges(batch, lane), deformation_gradient(batch, lane, displacement),
                      batch.mu[lane], batch.lambda[lane]);
  }
  return sum_to_nodes(bound);
}

std::string InternalForce::describe_worst_cell(const NodeVector& positions,
                                               const NodeVector& displacement, double bound) const {
  const std::size_t cell = kernel::find_cell_below(batches_->data.data(), batches_->n_cells,
                                                   displacement.begin(), bound);
  if (cell == batches_->n_cells)
    return {};
  Tensor<1, 3> centre;
  for (const unsigned node : body_.cells()[cell])
    centre += 0.25 * node_value(positions, node);
  const double J = determinant(
      deformation_gradient(batches_->data[cell / n_lanes], cell % n_lanes, displacement));
  const std::string place = format("cell %u near (%.1f, %.1f, %.1f) mm", body_.cell_ids()[cell],
                                   centre[0], centre[1], centre[2]);
  return std::abs(J) < 10. ? place + format(" with J = %.3g", J) : place;
}

} // namespace prosup::mechanics
