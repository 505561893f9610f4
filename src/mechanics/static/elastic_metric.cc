#include "prosup/mechanics/static/elastic_metric.h"

#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/solver_control.h>

#include <algorithm>

#include "cell_stiffness.h"
#include "mechanics/element/membrane.h"

namespace prosup::mechanics {

using namespace dealii;

namespace {

constexpr unsigned max_iterations = 2000;

} // namespace

/// K + H between nodal vectors, for deal.II's solvers.
class ElasticMetric::Operator : public Subscriptor {
public:
  Operator(const ElasticMetric& metric, const std::vector<Block>& blocks)
      : metric_(metric), blocks_(blocks) {}
  void vmult(NodeVector& result, const NodeVector& v) const {
    metric_.multiply(blocks_, v, result);
  }

private:
  const ElasticMetric& metric_;
  const std::vector<Block>& blocks_;
};

namespace {

/// Applies the inverse of the diagonal blocks within the allowed displacements.
struct BlockJacobi {
  const Supports& supports;
  const std::vector<Tensor<2, 3>>& inverse;

  void vmult(NodeVector& result, const NodeVector& v) const {
    for (unsigned node = 0; node < inverse.size(); ++node) {
      const Tensor<1, 3> value = inverse[node] * node_value(v, node);
      for (unsigned c = 0; c < 3; ++c)
        result.local_element(3 * node + c) = value[c];
    }
    supports.project(result);
  }
};

} // namespace

ElasticMetric::ElasticMetric(const Supports& supports, const Material& material,
                             const NodeVector& unloaded)
    : supports_(supports), body_(supports.body()) {
  list_couplings();
  add_elements(material, unloaded);
  add_skin(material.skin(), unloaded);
}

void ElasticMetric::list_couplings() {
  std::vector<std::vector<std::uint32_t>> columns(body_.n_local_nodes());
  for (unsigned node = 0; node < columns.size(); ++node)
    columns[node].push_back(node);
  for (const auto& cell : body_.cells())
    for (const unsigned row : cell)
      columns[row].insert(columns[row].end(), cell.begin(), cell.end());
  row_begin_.assign(1, 0);
  for (auto& row : columns) {
    std::sort(row.begin(), row.end());
    row.erase(std::unique(row.begin(), row.end()), row.end());
    column_.insert(column_.end(), row.begin(), row.end());
    row_begin_.push_back(static_cast<std::uint32_t>(column_.size()));
  }
  for (const auto& cell : body_.cells()) {
    auto& slots = slots_.emplace_back();
    for (unsigned a = 0; a < 4; ++a)
      for (unsigned b = 0; b < 4; ++b)
        slots[4 * a + b] = slot_of(cell[a], cell[b]);
  }
  blocks_.resize(column_.size());
}

std::uint32_t ElasticMetric::slot_of(unsigned row, unsigned column) const {
  const auto begin = column_.begin() + row_begin_[row], end = column_.begin() + row_begin_[row + 1];
  return static_cast<std::uint32_t>(std::lower_bound(begin, end, column) - column_.begin());
}

void ElasticMetric::add_skin(const Skin& skin, const NodeVector& unloaded) {
  for (const auto& triangle : membrane_triangles(body_, skin)) {
    const auto X = corners_of(triangle, unloaded);
    const auto blocks = MembraneTriangle(X, X, skin.stiffness).by_loaded();
    for (unsigned a = 0; a < 3; ++a)
      for (unsigned b = 0; b < 3; ++b)
        blocks_[slot_of(triangle[a], triangle[b])] += blocks[3 * a + b];
  }
}

void ElasticMetric::add_elements(const Material& material, const NodeVector& unloaded) {
  for_each_cell_stiffness(body_, material, unloaded, [&](unsigned cell, const CellBlocks& blocks) {
    for (unsigned i = 0; i < blocks.size(); ++i)
      blocks_[slots_[cell][i]] += blocks[i];
  });
  const std::vector<double>& springs = supports_.spring_stiffness();
  for (unsigned node = 0; node < std::min<std::size_t>(springs.size(), body_.n_owned_nodes());
       ++node)
    for (std::uint32_t i = row_begin_[node]; i < row_begin_[node + 1]; ++i)
      if (column_[i] == node)
        blocks_[i] += springs[node] * Tensor<2, 3>(unit_symmetric_tensor<3>());
}

void ElasticMetric::multiply(const NodeVector& v, NodeVector& result) const {
  multiply(blocks_, v, result);
}

void ElasticMetric::multiply(const std::vector<Block>& blocks, const NodeVector& v,
                             NodeVector& result) const {
  v.update_ghost_values();
  result = 0.;
  const double* in = v.begin();
  double* out = result.begin();
  for (unsigned node = 0; node + 1 < row_begin_.size(); ++node) {
    double sum[3] = {0., 0., 0.};
    for (std::uint32_t i = row_begin_[node]; i < row_begin_[node + 1]; ++i) {
      const double* x = in + 3 * column_[i];
      const Block& k = blocks[i];
      for (unsigned c = 0; c < 3; ++c)
        sum[c] += k[c][0] * x[0] + k[c][1] * x[1] + k[c][2] * x[2];
    }
    for (unsigned c = 0; c < 3; ++c)
      out[3 * node + c] += sum[c];
  }
  result.compress(VectorOperation::add);
  supports_.project(result);
}

std::vector<Tensor<2, 3>> ElasticMetric::inverse_diagonal(const std::vector<Block>& blocks) const {
  std::array<NodeVector, 3> columns;
  for (unsigned c = 0; c < 3; ++c) {
    body_.initialize(columns[c]);
    for (unsigned node = 0; node + 1 < row_begin_.size(); ++node)
      for (std::uint32_t i = row_begin_[node]; i < row_begin_[node + 1]; ++i)
        if (column_[i] == node)
          for (unsigned r = 0; r < 3; ++r)
            columns[c].local_element(3 * node + r) = blocks[i][r][c];
    columns[c].compress(VectorOperation::add);
  }
  std::vector<Block> inverse(body_.n_owned_nodes());
  for (unsigned node = 0; node < inverse.size(); ++node) {
    Block diagonal;
    for (unsigned c = 0; c < 3; ++c)
      for (unsigned r = 0; r < 3; ++r)
        diagonal[r][c] = columns[c].local_element(3 * node + r);
    inverse[node] = invert(diagonal);
  }
  return inverse;
}

unsigned ElasticMetric::solve(const std::vector<CellStiffness>& added, double factor,
                              const NodeVector& force, double tolerance,
                              NodeVector& displacement) const {
  std::vector<Block> blocks = blocks_;
  for (std::size_t cell = 0; cell < added.size(); ++cell) {
    unsigned pair = 0;
    for (unsigned a = 0; a < 4; ++a)
      for (unsigned b = a; b < 4; ++b, ++pair) {
        const Block block = factor * Tensor<2, 3>(added[cell][pair]);
        blocks[slots_[cell][4 * a + b]] += block;
        if (a != b)
          blocks[slots_[cell][4 * b + a]] += block;
      }
  }
  body_.initialize(displacement);
  NodeVector right_side;
  body_.initialize(right_side);
  std::copy_n(force.begin(), 3 * body_.n_owned_nodes(), right_side.begin());
  supports_.project(right_side);
  const std::vector<Block> inverse = inverse_diagonal(blocks);
  const double norm = right_side.l2_norm();
  if (!(norm > 0.))
    return 0;
  IterationNumberControl control(max_iterations, tolerance * norm);
  SolverCG<NodeVector>(control).solve(Operator(*this, blocks), displacement, right_side,
                                      BlockJacobi{supports_, inverse});
  return control.last_step();
}

} // namespace prosup::mechanics
