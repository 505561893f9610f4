#include "mechanics/static/equilibrium.h"

#include <deal.II/base/mpi.h>
#include <gtest/gtest.h>

#include <cmath>

#include "all_laws.h"
#include "box.h"
#include "prosup/mechanics/body/boundary.h"
#include "prosup/mechanics/laws/stress.h"

namespace prosup::tests {
namespace {

using namespace dealii;
using namespace prosup::mechanics;

const Tensor<1, 3> weight({0.3, -9.81, 0.5});
constexpr double fraction = 0.7;

/// A spring that pulls by the position and its change, unsymmetric on purpose.
struct Spring : NodalForce {
  bool evaluate(unsigned node, const Tensor<1, 3>& X, const Tensor<1, 3>& x, Tensor<1, 3>& force,
                Tensor<2, 3>& by_x, Tensor<2, 3>& by_X) const override {
    if (node % 2 == 0)
      return false;
    by_x = by_X = Tensor<2, 3>();
    for (unsigned c = 0; c < 3; ++c) {
      const unsigned next = (c + 1) % 3;
      force[c] = -40. * x[c] * x[c] - 25. * (x[next] - X[next]);
      by_x[c][c] = -80. * x[c];
      by_x[c][next] = -25.;
      by_X[c][next] = 25.;
    }
    return true;
  }
};

/// A small box of two materials, bent, held at low y.
class EquilibriumOfABox : public ::testing::TestWithParam<std::tuple<ElementType, unsigned>> {
protected:
  EquilibriumOfABox()
      : mesh(make_box(MPI_COMM_WORLD, {2, 3, 2}, {4., 6., 5.})),
        body(*mesh, Element{type, Precision::double_precision}), equations(body) {
    body.initialize(nodal);
    nodal = 3.;
    std::vector<LameParameters> of_elements;
    for (unsigned e = 0; e < body.n_elements(); ++e) {
      const bool gland = node_value(body.vertex_positions(), body.element_nodes(e)[0])[1] > 2.9;
      of_elements.push_back(lame_parameters(gland ? 500. : 200., 0.45));
    }
    material = {of_elements, all_laws()[std::get<1>(GetParam())]};
    fixed = nodes_on_boundary(body, {2});
    equations.set_material(material);
    equations.set_fixed_nodes(fixed);
    equations.set_external_force(weight, nodal);
    equations.set_load_fraction(fraction);
    X = field([](const Tensor<1, 3>& p) {
      return Tensor<1, 3>({p[0] + 0.1 * std::sin(p[1]), p[1] + 0.1 * std::cos(2. * p[0]), p[2]});
    });
    x = field([](const Tensor<1, 3>& p) {
      return Tensor<1, 3>({p[0] + 0.3 * std::sin(p[1]), 1.2 * p[1],
                           p[2] + 0.1 * p[0] * std::sin(p[1]) + 0.2 * std::cos(p[0])});
    });
  }

  template <typename Function>
  NodeVector field(const Function& function) const {
    NodeVector vector;
    body.initialize(vector);
    for (unsigned node = 0; node < body.n_owned_nodes(); ++node)
      for (unsigned c = 0; c < 3; ++c)
        vector.local_element(3 * node + c) = function(node_value(body.vertex_positions(), node))[c];
    vector.update_ghost_values();
    return vector;
  }

  /// A direction that leaves fixed nodes where they are.
  NodeVector direction(double phase) const {
    NodeVector d = field([phase](const Tensor<1, 3>& p) {
      return Tensor<1, 3>({std::sin(3. * p[0] + p[1] + phase), std::cos(2. * p[1] + p[2] - phase),
                           std::sin(p[0] + 2. * p[2] + 2. * phase)});
    });
    d.zero_out_ghost_values();
    for (unsigned i = 0; i < d.locally_owned_size(); ++i)
      if (fixed[i / 3])
        d.local_element(i) = 0.;
    d.update_ghost_values();
    return d;
  }

  NodeVector moved(const NodeVector& from, double factor, const NodeVector& d) const {
    NodeVector to;
    body.initialize(to);
    for (unsigned i = 0; i < to.locally_owned_size(); ++i)
      to.local_element(i) = from.local_element(i) + factor * d.local_element(i);
    to.update_ghost_values();
    return to;
  }

  NodeVector residual(const NodeVector& unknown) const {
    NodeVector r;
    body.initialize(r);
    EXPECT_GT(equations.residual(unknown, r), 0.);
    return r;
  }

  /// K d with the rows and columns wherever they were added up.
  NodeVector times(const NodeVector& unknown, const NodeVector& d) const {
    const unsigned n = 3 * n_global_nodes(body);
    std::vector<double> whole(n, 0.), product(n, 0.);
    const unsigned begin = static_cast<unsigned>(*d.locally_owned_elements().begin());
    for (unsigned i = 0; i < d.locally_owned_size(); ++i)
      whole[begin + i] = d.local_element(i);
    Utilities::MPI::sum(whole, MPI_COMM_WORLD, whole);
    equations.tangent(unknown, [&](const auto& nodes, const auto& values) {
      const std::size_t m = 3 * nodes.size();
      for (std::size_t i = 0; i < m; ++i)
        for (std::size_t j = 0; j < m; ++j)
          product[3 * nodes[i / 3] + i % 3] += values[i * m + j] * whole[3 * nodes[j / 3] + j % 3];
    });
    Utilities::MPI::sum(product, MPI_COMM_WORLD, product);
    NodeVector result;
    body.initialize(result);
    for (unsigned i = 0; i < result.locally_owned_size(); ++i)
      result.local_element(i) = product[begin + i];
    return result;
  }

  void expect_tangent(Unknown unknown) {
    equations.set_problem(unknown, unknown == Unknown::loaded ? X : x);
    const NodeVector& y = unknown == Unknown::loaded ? x : X;
    const NodeVector d = direction(0.4);
    constexpr double step = 1e-6;
    NodeVector expected = residual(moved(y, step, d));
    expected -= residual(moved(y, -step, d));
    expected *= 1. / (2. * step);
    NodeVector difference = times(y, d);
    difference -= expected;
    EXPECT_LT(difference.linfty_norm(), 1e-7 * expected.linfty_norm());
  }

  const ElementType type = std::get<0>(GetParam());
  std::unique_ptr<Distributed> mesh;
  Body body;
  Equilibrium equations;
  Material material;
  std::vector<bool> fixed;
  NodeVector nodal, X, x;
};

/// Volume of a tetrahedron with straight edges.
double volume(const Body& body, unsigned e, const NodeVector& positions) {
  const unsigned* n = body.element_nodes(e);
  const auto p = [&](unsigned a) {
    return node_value(positions, n[a]) - node_value(positions, n[0]);
  };
  return p(1) * cross_product_3d(p(2), p(3)) / 6.;
}

/// The energy of nodal_pressure elements as it is defined, over all ranks.
double nodal_pressure_energy(const Body& body, const Material& material, const NodeVector& X,
                             const NodeVector& x) {
  std::vector<double> V(body.n_local_nodes(), 0.), v(V), lambda(V);
  double energy = 0.;
  for (unsigned e = 0; e < body.n_elements(); ++e) {
    const double V_e = volume(body, e, X), v_e = volume(body, e, x);
    Tensor<2, 3> edges_X, edges_x;
    for (unsigned b = 0; b < 3; ++b)
      for (unsigned c = 0; c < 3; ++c) {
        const unsigned *n = body.element_nodes(e), i = n[b + 1], o = n[0];
        edges_X[c][b] = node_value(X, i)[c] - node_value(X, o)[c];
        edges_x[c][b] = node_value(x, i)[c] - node_value(x, o)[c];
      }
    const Tensor<2, 3> F = edges_x * invert(edges_X);
    energy += V_e * energy_density(F, {material[e].mu, 0.}, material.law());
    for (unsigned a = 0; a < 4; ++a) {
      const unsigned node = body.element_nodes(e)[a];
      V[node] += V_e / 4.;
      v[node] += v_e / 4.;
      lambda[node] += V_e * material[e].lambda / 4.;
    }
  }
  V = sum_over_ranks(body, V);
  v = sum_over_ranks(body, v);
  lambda = sum_over_ranks(body, lambda);
  for (unsigned a = 0; a < body.n_owned_nodes(); ++a)
    energy += lambda[a] / 2. * std::pow(std::log(v[a] / V[a]), 2);
  return Utilities::MPI::sum(energy, MPI_COMM_WORLD);
}

TEST_P(EquilibriumOfABox, TangentByLoadedPositionsEqualsDifferencesAndIsSymmetric) {
  expect_tangent(Unknown::loaded);
  const NodeVector d = direction(0.4), other = direction(1.3);
  const double one = times(x, d) * other, two = times(x, other) * d;
  EXPECT_NEAR(one, two, 1e-11 * std::abs(one));
}

TEST_P(EquilibriumOfABox, TangentByUnloadedPositionsEqualsDifferences) {
  expect_tangent(Unknown::unloaded);
}

TEST_P(EquilibriumOfABox, TangentsOfNodalForces) {
  const Spring spring;
  equations.set_nodal_force(&spring);
  expect_tangent(Unknown::loaded);
  expect_tangent(Unknown::unloaded);
}

TEST_P(EquilibriumOfABox, InvertedStatesHaveNoPositiveJacobian) {
  equations.set_problem(Unknown::loaded, X);
  NodeVector r;
  body.initialize(r);
  EXPECT_LT(equations.residual(moved(X, -1.5, X), r), 0.);
}

TEST_P(EquilibriumOfABox, WeightIsWhatTheVolumeWeighs) {
  nodal = 0.;
  equations.set_external_force(weight, nodal);
  equations.set_fixed_nodes(std::vector<bool>(body.n_local_nodes(), false));
  equations.set_problem(Unknown::loaded, body.vertex_positions());
  const NodeVector r = residual(body.vertex_positions()); // no stress, weight alone
  Tensor<1, 3> sum;
  for (unsigned node = 0; node < body.n_owned_nodes(); ++node)
    sum += node_value(r, node);
  sum = Utilities::MPI::sum(sum, MPI_COMM_WORLD);
  for (unsigned c = 0; c < 3; ++c)
    EXPECT_NEAR(sum[c], -fraction * 120. * weight[c], 1e-9);
}

TEST_P(EquilibriumOfABox, AveragedPressuresAreTheDerivativeOfTheirEnergy) {
  if (type != ElementType::nodal_pressure)
    GTEST_SKIP();
  nodal = 0.;
  equations.set_external_force(Tensor<1, 3>(), nodal);
  equations.set_problem(Unknown::loaded, X);
  const NodeVector d = direction(0.4);
  constexpr double step = 1e-5;
  const double expected = (nodal_pressure_energy(body, material, X, moved(x, step, d)) -
                           nodal_pressure_energy(body, material, X, moved(x, -step, d))) /
                          (2. * step);
  EXPECT_NEAR(residual(x) * d, expected, 1e-7 * std::abs(expected));
}

INSTANTIATE_TEST_SUITE_P(Elements, EquilibriumOfABox,
                         ::testing::Combine(::testing::Values(ElementType::linear,
                                                              ElementType::nodal_pressure,
                                                              ElementType::quadratic),
                                            ::testing::Range(0u, unsigned(law_names().size()))));

} // namespace
} // namespace prosup::tests
