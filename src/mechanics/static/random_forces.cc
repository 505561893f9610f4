#include "prosup/mechanics/static/random_forces.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "cell_stiffness.h"
#include "mechanics/element/membrane.h"

namespace prosup::mechanics {

using namespace dealii;

namespace {

constexpr double smallest_pivot = 1e-10; // over the largest entry: rigid motions have no stiffness
constexpr std::uint64_t spring_stream = 0x5bd1e995;

/// Between the components at n / 3 corners.
template <std::size_t n>
using CornerMatrix = std::array<std::array<double, n>, n>;

/// Spreads numbers that differ in one bit over all bits (splitmix64).
std::uint64_t mixed(std::uint64_t z) {
  z += 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

/// A number that is the same for a node on every rank that knows it.
std::uint64_t key_of(const Tensor<1, 3>& position) {
  std::uint64_t key = spring_stream;
  for (unsigned c = 0; c < 3; ++c) {
    std::uint64_t bits;
    const double value = position[c] + 0.; // -0 is 0
    std::memcpy(&bits, &value, sizeof bits);
    key = mixed(key ^ bits);
  }
  return key;
}

double sign(std::uint64_t bits, unsigned i) {
  return (bits >> i & 1) != 0 ? 1. : -1.;
}

/// From the blocks of all pairs of corners.
template <std::size_t n_corners, typename Blocks>
CornerMatrix<3 * n_corners> dense(const Blocks& blocks) {
  CornerMatrix<3 * n_corners> matrix;
  for (unsigned i = 0; i < matrix.size(); ++i)
    for (unsigned j = 0; j < matrix.size(); ++j)
      matrix[i][j] = blocks[n_corners * (i / 3) + j / 3][i % 3][j % 3];
  return matrix;
}

CornerMatrix<12> sum_of(const CellBlocks& blocks, const CellStiffness* added, double factor) {
  CornerMatrix<12> sum = dense<4>(blocks);
  if (added == nullptr)
    return sum;
  unsigned pair = 0;
  for (unsigned a = 0; a < 4; ++a)
    for (unsigned b = a; b < 4; ++b, ++pair)
      for (unsigned c = 0; c < 3; ++c)
        for (unsigned d = 0; d < 3; ++d) {
          const double value = factor * (*added)[pair][c][d];
          sum[3 * a + c][3 * b + d] += value;
          if (a != b)
            sum[3 * b + d][3 * a + c] += value;
        }
  return sum;
}

/// Replaces the lower triangle of a positive semidefinite matrix by its Cholesky factor, with
/// columns of 0 where nothing is left.
template <std::size_t n>
void factorize(CornerMatrix<n>& m) {
  double largest = 0.;
  for (unsigned i = 0; i < n; ++i)
    largest = std::max(largest, m[i][i]);
  for (unsigned j = 0; j < n; ++j) {
    double pivot = m[j][j];
    for (unsigned k = 0; k < j; ++k)
      pivot -= m[j][k] * m[j][k];
    const bool counts = pivot > smallest_pivot * largest;
    m[j][j] = counts ? std::sqrt(pivot) : 0.;
    for (unsigned i = j + 1; i < n; ++i) {
      double value = m[i][j];
      for (unsigned k = 0; k < j; ++k)
        value -= m[i][k] * m[j][k];
      m[i][j] = counts ? value / m[j][j] : 0.;
    }
  }
}

/// Adds the matrix's factor times random signs.
template <std::size_t n_corners>
void add_part(CornerMatrix<3 * n_corners> factor, std::uint64_t key,
              const std::array<unsigned, n_corners>& nodes, std::vector<NodeVector>& forces) {
  factorize(factor);
  for (unsigned n = 0; n < forces.size(); ++n) {
    const std::uint64_t bits = mixed(mixed(key) + n);
    for (unsigned i = 0; i < factor.size(); ++i) {
      double value = 0.;
      for (unsigned k = 0; k <= i; ++k)
        value += factor[i][k] * sign(bits, k);
      forces[n].local_element(3 * nodes[i / 3] + i % 3) += value;
    }
  }
}

} // namespace

std::vector<NodeVector> random_forces(const Supports& supports, const Material& material,
                                      const NodeVector& unloaded,
                                      const std::vector<CellStiffness>& added, double factor,
                                      unsigned n) {
  const Body& body = supports.body();
  std::vector<NodeVector> forces(n);
  for (NodeVector& force : forces)
    body.initialize(force);
  for_each_cell_stiffness(body, material, unloaded, [&](unsigned cell, const CellBlocks& blocks) {
    add_part(sum_of(blocks, added.empty() ? nullptr : &added[cell], factor), body.cell_ids()[cell],
             body.cells()[cell], forces);
  });
  for (const auto& triangle : membrane_triangles(body, material.skin())) {
    const auto X = corners_of(triangle, unloaded);
    const auto blocks = MembraneTriangle(X, X, material.skin().stiffness).by_loaded();
    const auto at = corners_of(triangle, body.vertex_positions());
    add_part(dense<3>(blocks), key_of(at[0] + at[1] + at[2]), triangle, forces);
  }
  const std::vector<double>& springs = supports.spring_stiffness();
  for (unsigned m = 0; m < n; ++m) {
    forces[m].compress(VectorOperation::add);
    for (unsigned node = 0; node < body.n_owned_nodes() && !springs.empty(); ++node) {
      const std::uint64_t bits = mixed(key_of(node_value(body.vertex_positions(), node)) + m);
      for (unsigned c = 0; c < 3; ++c)
        forces[m].local_element(3 * node + c) += std::sqrt(springs[node]) * sign(bits, c);
    }
  }
  return forces;
}

} // namespace prosup::mechanics
