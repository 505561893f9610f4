#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_simplex_p.h>
#include <gtest/gtest.h>

#include <cmath>

#include "figures.h"
#include "prosup/mechanics/body/boundary.h"
#include "prosup/mechanics/laws/stress.h"
#include "static_box.h"

namespace prosup::tests {
namespace {

using namespace dealii;
using namespace prosup::mechanics;

constexpr double edge = 40.; // mm
const LameParameters material = lame_parameters(400., 0.45);

/// u(X), smooth, with strains of some tenths.
Tensor<1, 3> displacement(const Tensor<1, 3>& X) {
  const double k = M_PI / edge;
  return Tensor<1, 3>({2.5 * std::sin(k * X[1]) * std::cos(0.7 * k * X[2]),
                       2. * std::cos(0.8 * k * X[0]) * std::sin(0.5 * k * X[1] + 0.3),
                       -2. * std::sin(0.9 * k * X[0] + 0.5 * k * X[2])});
}

/// d/dX_j of a field, by central differences of sixth order.
template <typename Field>
auto slope(const Field& field, const Tensor<1, 3>& X, unsigned j) {
  constexpr double h = 0.05; // mm: errors of (k h)^6 and of 1e-16/h
  const auto difference = [&](double n) {
    Tensor<1, 3> step;
    step[j] = n * h;
    return field(X + step) - field(X - step);
  };
  return (45. * difference(1.) - 9. * difference(2.) + difference(3.)) / (60. * h);
}

Tensor<2, 3> stress(const Tensor<1, 3>& X) {
  Tensor<2, 3> F;
  for (unsigned j = 0; j < 3; ++j) {
    const Tensor<1, 3> column = slope(displacement, X, j);
    for (unsigned i = 0; i < 3; ++i)
      F[i][j] = (i == j) + column[i];
  }
  return first_piola_kirchhoff_stress(F, material);
}

/// b = -Div P, g/(mm^2 s^2).
Tensor<1, 3> body_force(const Tensor<1, 3>& X) {
  Tensor<1, 3> b;
  for (unsigned j = 0; j < 3; ++j) {
    const Tensor<2, 3> by_j = slope(stress, X, j);
    for (unsigned i = 0; i < 3; ++i)
      b[i] -= by_j[i][j];
  }
  return b;
}

/// Calls visit(element, shape values, X, weight) at points of a fine rule.
template <typename Visit>
void visit_points(const Body& body, const Visit& visit) {
  const FE_SimplexP<3> shape(body.element().degree());
  const QWitherdenVincentSimplex<3> quadrature(3); // exact to degree 5
  std::vector<double> values(shape.n_dofs_per_cell());
  for (unsigned e = 0; e < body.n_elements(); ++e) {
    const unsigned* nodes = body.element_nodes(e);
    const Tensor<1, 3> corner = node_value(body.vertex_positions(), nodes[0]);
    Tensor<2, 3> D;
    for (unsigned a = 1; a < 4; ++a)
      for (unsigned i = 0; i < 3; ++i)
        D[i][a - 1] = (node_value(body.vertex_positions(), nodes[a]) - corner)[i];
    for (unsigned q = 0; q < quadrature.size(); ++q) {
      for (unsigned a = 0; a < values.size(); ++a)
        values[a] = shape.shape_value(a, quadrature.point(q));
      visit(nodes, values, corner + D * Tensor<1, 3>(quadrature.point(q)),
            quadrature.weight(q) * determinant(D));
    }
  }
}

/// int N_a b dV at the owned nodes, g mm/s^2.
NodeVector nodal_body_force(const Body& body) {
  std::array<std::vector<double>, 3> sums;
  for (auto& sum : sums)
    sum.assign(body.n_local_nodes(), 0.);
  visit_points(
      body, [&](const unsigned* nodes, const std::vector<double>& N, const auto& X, double weight) {
        const Tensor<1, 3> b = body_force(X);
        for (unsigned a = 0; a < N.size(); ++a)
          for (unsigned c = 0; c < 3; ++c)
            sums[c][nodes[a]] += weight * N[a] * b[c];
      });
  NodeVector force;
  body.initialize(force);
  for (unsigned c = 0; c < 3; ++c) {
    const std::vector<double> sum = sum_over_ranks(body, sums[c]);
    for (unsigned node = 0; node < body.n_owned_nodes(); ++node)
      force.local_element(3 * node + c) = sum[node];
  }
  return force;
}

struct Errors {
  double l2;  ///< root of the mean square, mm
  double max; ///< at the nodes, mm
};

Errors errors(const Body& body, const NodeVector& u) {
  double squares = 0., largest = 0.;
  visit_points(
      body, [&](const unsigned* nodes, const std::vector<double>& N, const auto& X, double weight) {
        Tensor<1, 3> difference = -displacement(X);
        for (unsigned a = 0; a < N.size(); ++a)
          difference += N[a] * node_value(u, nodes[a]);
        squares += weight * difference.norm_square();
      });
  for (unsigned node = 0; node < body.n_owned_nodes(); ++node)
    largest = std::max(
        largest,
        (node_value(u, node) - displacement(node_value(body.vertex_positions(), node))).norm());
  return {std::sqrt(Utilities::MPI::sum(squares, MPI_COMM_WORLD) / std::pow(edge, 3)),
          Utilities::MPI::max(largest, MPI_COMM_WORLD)};
}

Errors solve(ElementType type, unsigned n) {
  StaticBox box({n, n, n}, {edge, edge, edge}, type, material);
  const std::vector<bool> boundary = nodes_on_boundary(box.body, {0, 1, 2, 3, 4, 5});
  box.solver.set_fixed_nodes(boundary);
  box.solver.set_body_force({});
  box.solver.set_external_force(nodal_body_force(box.body));
  // The nodes inside start from an answer that is wrong by up to half a millimetre.
  for (unsigned node = 0; node < box.body.n_owned_nodes(); ++node) {
    const Tensor<1, 3> u = displacement(node_value(box.body.vertex_positions(), node));
    for (unsigned c = 0; c < 3; ++c)
      box.displacement.local_element(3 * node + c) = (boundary[node] ? 1. : 0.8) * u[c];
  }
  box.displacement.update_ghost_values();
  EXPECT_TRUE(box.load().converged);
  return errors(box.body, box.displacement);
}

/// Errors on the meshes of n[k] bricks per edge; `least_rate` between the finest two.
void expect_rate(ElementType type, const std::vector<unsigned>& n, double least_rate) {
  std::string list;
  Errors last{}, finest{};
  for (const unsigned m : n) {
    last = finest;
    finest = solve(type, m);
    list += format("%s%.2e/%.2e", list.empty() ? "" : ", ", finest.l2, finest.max);
  }
  const double ratio = std::log2(double(n.back()) / n[n.size() - 2]);
  const double rate = std::log2(last.l2 / finest.l2) / ratio;
  EXPECT_GT(rate, least_rate);
  tell_figure("manufactured solution, nu = 0.45, " + name_of(type) +
                  format(", %u to %u bricks per edge", n.front(), n.back()),
              "u(X) chosen, body force -Div P",
              "rate " + format("%.2f", rate) + " in L2; error L2/max " + list + " mm",
              format("rate > %.2f", least_rate));
}

TEST(ManufacturedSolution, LinearIsOfSecondOrder) {
  expect_rate(ElementType::linear, {4, 8, 16}, 1.85);
}

TEST(ManufacturedSolution, NodalPressureIsOfSecondOrder) {
  expect_rate(ElementType::nodal_pressure, {4, 8, 16}, 1.85);
}

TEST(ManufacturedSolution, QuadraticIsOfThirdOrder) {
  expect_rate(ElementType::quadratic, {2, 4, 8}, 2.8);
}

} // namespace
} // namespace prosup::tests
