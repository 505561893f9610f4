#include <deal.II/base/mpi.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <string>

#include "mechanics/element/membrane.h"
#include "prosup/mechanics/element/internal_force.h"
#include "prosup/mechanics/static/elastic_metric.h"
#include "static_box.h"

namespace prosup::tests {
namespace {

using namespace dealii;
using namespace prosup::mechanics;

constexpr double stiffness = 5000.; // Pa mm
const MembraneTriangle::Corners unloaded{
    Tensor<1, 3>({0.2, -0.1, 0.3}), Tensor<1, 3>({3.1, 0.4, -0.2}), Tensor<1, 3>({0.9, 2.7, 0.8})};
const MembraneTriangle::Corners loaded{Tensor<1, 3>({1.2, 0.3, 0.1}), Tensor<1, 3>({4.5, 0.9, 0.7}),
                                       Tensor<1, 3>({1.4, 3.1, -0.6})};

const Tensor<1, 3> edge1 = unloaded[1] - unloaded[0], edge2 = unloaded[2] - unloaded[0];

/// Corners moved by stretches along the first edge and across it, then turned out of the plane.
MembraneTriangle::Corners stretched(double along, double across) {
  const Tensor<1, 3> e = edge1 / edge1.norm();
  Tensor<1, 3> f = edge2 - (edge2 * e) * e;
  f /= f.norm();
  const Tensor<1, 3> e_new({0.6, 0.8, 0.}), f_new({0., 0., 1.});
  MembraneTriangle::Corners x;
  for (unsigned a = 0; a < 3; ++a) {
    const Tensor<1, 3> X = unloaded[a] - unloaded[0];
    x[a] = along * (X * e + 0.1 * (X * f)) * e_new + across * (X * f) * f_new;
  }
  return x;
}

const std::map<std::string, MembraneTriangle::Corners> states{
    {"taut", loaded}, {"wrinkled", stretched(1.3, 0.7)}, {"slack", stretched(0.9, 0.8)}};

/// The energy by the eigenvalues of F^T F, from orthonormal axes in the plane.
double energy(const MembraneTriangle::Corners& X, const MembraneTriangle::Corners& x) {
  const Tensor<1, 3> D1 = X[1] - X[0], D2 = X[2] - X[0];
  const Tensor<1, 3> e1 = D1 / D1.norm(), normal = cross_product_3d(D1, D2);
  const Tensor<1, 3> e2 = cross_product_3d(normal / normal.norm(), e1);
  Tensor<2, 2> D;
  D[0][0] = D1 * e1;
  D[0][1] = D2 * e1;
  D[1][0] = D1 * e2;
  D[1][1] = D2 * e2;
  const Tensor<2, 2> inverse = invert(D);
  const Tensor<1, 3> d1 = x[1] - x[0], d2 = x[2] - x[0];
  const Tensor<1, 3> f1 = inverse[0][0] * d1 + inverse[1][0] * d2,
                     f2 = inverse[0][1] * d1 + inverse[1][1] * d2;
  const double trace = f1 * f1 + f2 * f2, determinant = cross_product_3d(f1, f2).norm_square();
  const double a = 0.5 * trace + std::sqrt(0.25 * trace * trace - determinant), b = trace - a;
  const double density = b * std::sqrt(a) > 1. ? trace + 1. / determinant - 3.
                         : a > 1.              ? a + 2. / std::sqrt(a) - 3.
                                               : 0.;
  return 0.5 * normal.norm() * 0.5 * stiffness * density;
}

std::string state_of(const MembraneTriangle::Corners& X, const MembraneTriangle::Corners& x) {
  const Tensor<1, 3> D1 = X[1] - X[0], D2 = X[2] - X[0], d1 = x[1] - x[0], d2 = x[2] - x[0];
  const PlaneMatrix M{D1 * D1, D1 * D2, D2 * D2};
  const MembraneStretch stretch(M.inverse(), M.determinant(), {d1 * d1, d1 * d2, d2 * d2});
  return stretch.is_taut() ? "taut" : stretch.is_stretched() ? "wrinkled" : "slack";
}

TEST(MembraneTriangle, TheStatesUnderTestAreWhatTheyAreCalled) {
  for (const auto& [name, x] : states) {
    EXPECT_EQ(state_of(unloaded, x), name);
    EXPECT_EQ(energy(unloaded, x) > 0., name != "slack");
  }
  // Across its wrinkles a skin does not pull.
  EXPECT_NEAR(energy(unloaded, stretched(1.3, 0.6)), energy(unloaded, stretched(1.3, 0.5)),
              0.1 * energy(unloaded, stretched(1.3, 0.5)));
}

TEST(MembraneTriangle, ForcesAreTheDerivativeOfTheEnergy) {
  const double h = 1e-5;
  for (const auto& [name, x] : states) {
    const auto forces = MembraneTriangle(unloaded, x, stiffness).forces();
    for (unsigned a = 0; a < 3; ++a)
      for (unsigned c = 0; c < 3; ++c) {
        auto ahead = x, behind = x;
        ahead[a][c] += h;
        behind[a][c] -= h;
        const double slope = (energy(unloaded, ahead) - energy(unloaded, behind)) / (2. * h);
        EXPECT_NEAR(forces[a][c], slope, 1e-6 * stiffness) << name << a << c;
      }
  }
}

TEST(MembraneTriangle, TangentsAreTheDerivativesOfTheForces) {
  const double h = 1e-5;
  for (const auto& [name, at] : states) {
    const MembraneTriangle triangle(unloaded, at, stiffness);
    const auto by_x = triangle.by_loaded(), by_X = triangle.by_unloaded();
    for (unsigned b = 0; b < 3; ++b)
      for (unsigned j = 0; j < 3; ++j)
        for (const bool moves_loaded : {true, false}) {
          const auto forces = [&, x = at](double step) {
            auto X = unloaded, moved = x;
            (moves_loaded ? moved : X)[b][j] += step;
            return MembraneTriangle(X, moved, stiffness).forces();
          };
          const auto ahead = forces(h), behind = forces(-h);
          for (unsigned a = 0; a < 3; ++a)
            for (unsigned i = 0; i < 3; ++i)
              EXPECT_NEAR((moves_loaded ? by_x : by_X)[3 * a + b][i][j],
                          (ahead[a][i] - behind[a][i]) / (2. * h), 1e-6 * stiffness)
                  << name << moves_loaded << a << b << i << j;
        }
  }
}

/// A box with skin on its face at high z.
Material with_skin(double shear_modulus = 400.) {
  Material material(lame_parameters(shear_modulus, 0.45));
  material.set_skin({5, stiffness});
  return material;
}

const Point<3> size(30., 20., 25.);

// A sheet stretched alike in both directions pulls with s (lambda - lambda^-5) per unloaded length
// of its border (Holzapfel 2000, balloon).
TEST(Skin, StretchedSheetAgainstItsExactTension) {
  const double lambda = 1.2;
  for (const ElementType type : {ElementType::linear, ElementType::quadratic}) {
    const auto mesh = make_box(MPI_COMM_WORLD, {4, 3, 4}, size);
    const Body body(*mesh, Element{type});
    NodeVector X = body.vertex_positions(), u, without, with;
    X.update_ghost_values();
    for (NodeVector* vector : {&u, &without, &with})
      body.initialize(*vector);
    for (unsigned node = 0; node < body.n_owned_nodes(); ++node)
      for (unsigned c = 0; c < 2; ++c)
        u.local_element(3 * node + c) = (lambda - 1.) * node_value(X, node)[c];
    InternalForce force(body);
    force.set_material(lame_parameters(400., 0.45));
    force.set_reference(X);
    const std::vector<double> bound = force.stiffness_bound(u);
    force.subtract(u, without);
    force.set_material(with_skin());
    force.subtract(u, with);
    double pull = 0., total = 0.;
    for (unsigned node = 0; node < body.n_owned_nodes(); ++node) {
      const Tensor<1, 3> change = node_value(without, node) - node_value(with, node);
      total += change.norm();
      if (node_value(X, node)[0] > size[0] - 1e-6)
        pull += change[0];
      EXPECT_NEAR(change[2], 0., 1e-9 * stiffness);
    }
    const double expected = size[1] * stiffness * (lambda - std::pow(lambda, -5.));
    EXPECT_NEAR(Utilities::MPI::sum(pull, MPI_COMM_WORLD), expected, 1e-9 * expected);
    EXPECT_LT(Utilities::MPI::sum(total, MPI_COMM_WORLD), 5. * expected); // at its border only
    const std::vector<double> stiffer = force.stiffness_bound(u);
    for (unsigned node = 0; node < body.n_owned_nodes(); ++node)
      if (node_value(X, node)[2] > size[2] - 1e-6)
        EXPECT_GT(stiffer[node], bound[node] + stiffness);
      else
        EXPECT_NEAR(stiffer[node], bound[node], 1e-9 * bound[node]);
  }
}

// Both write the same stress in their own way; a waved face is taut here and wrinkled there.
TEST(Skin, ForcesAreThoseOfItsTriangles) {
  for (const ElementType type : {ElementType::linear, ElementType::quadratic}) {
    const auto mesh = make_box(MPI_COMM_WORLD, {4, 3, 4}, size);
    const Body body(*mesh, Element{type});
    NodeVector X = body.vertex_positions(), u, force, expected;
    X.update_ghost_values();
    for (NodeVector* vector : {&u, &force, &expected})
      body.initialize(*vector);
    for (unsigned node = 0; node < body.n_owned_nodes(); ++node) {
      const Tensor<1, 3> at = node_value(X, node);
      u.local_element(3 * node) = 2. * std::sin(0.4 * at[0]) - 0.05 * at[1];
      u.local_element(3 * node + 1) = 1.5 * std::cos(0.3 * at[0] + 0.2 * at[1]);
      u.local_element(3 * node + 2) = 0.5 * std::sin(0.5 * at[1]);
    }
    u.update_ghost_values();
    NodeVector x = X;
    x += u;
    x.update_ghost_values();
    std::set<std::string> kinds;
    for (const auto& triangle : membrane_triangles(body, {5, stiffness})) {
      const auto before = corners_of(triangle, X), after = corners_of(triangle, x);
      const auto forces = MembraneTriangle(before, after, stiffness).forces();
      for (unsigned a = 0; a < 3; ++a)
        for (unsigned c = 0; c < 3; ++c)
          expected.local_element(3 * triangle[a] + c) += forces[a][c];
      kinds.insert(state_of(before, after));
    }
    expected.compress(VectorOperation::add);
    if (Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) == 1) {
      EXPECT_GE(kinds.size(), 2u);
    }
    for (const bool has_skin : {false, true}) {
      InternalForce internal(body);
      internal.set_material(has_skin ? with_skin() : lame_parameters(400., 0.45));
      internal.set_reference(X);
      force *= -1.;
      internal.subtract(u, force);
    } // first minus the force without skin, then that minus the one with it
    force += expected;
    EXPECT_LT(force.linfty_norm(), 1e-9 * expected.linfty_norm());
  }
}

// At rest the second derivative of s/2 (tr C + 1/det C - 3) is 2 s (e : e + tr(e)^2).
TEST(Skin, ElasticMetricHoldsItsSmallStrains) {
  const auto mesh = make_box(MPI_COMM_WORLD, {4, 3, 4}, size);
  const Body body(*mesh);
  Supports supports(body);
  NodeVector X = body.vertex_positions(), u, force;
  X.update_ghost_values();
  body.initialize(u);
  body.initialize(force);
  Tensor<2, 3> gradient;
  gradient[0][0] = 0.1;
  gradient[0][1] = 0.06;
  gradient[1][1] = -0.03;
  gradient[2][0] = 0.2; // turns the sheet
  for (unsigned node = 0; node < body.n_owned_nodes(); ++node)
    for (unsigned c = 0; c < 3; ++c)
      u.local_element(3 * node + c) = (gradient * node_value(X, node))[c];
  double energy[2];
  for (const bool has_skin : {false, true}) {
    const ElasticMetric metric(supports, has_skin ? with_skin() : lame_parameters(400., 0.45), X);
    metric.multiply(u, force);
    energy[has_skin] = 0.5 * (force * u);
  }
  const double trace = 0.1 - 0.03, square = 0.1 * 0.1 + 0.03 * 0.03 + 2. * 0.03 * 0.03;
  const double expected = size[0] * size[1] * stiffness * (square + trace * trace);
  EXPECT_NEAR(energy[1] - energy[0], expected, 1e-9 * expected);
}

double mean_sag(const StaticBox& box) {
  double sum = 0.;
  for (unsigned node = 0; node < box.body.n_owned_nodes(); ++node)
    sum -= node_value(box.displacement, node)[1];
  return Utilities::MPI::sum(sum, MPI_COMM_WORLD) / n_global_nodes(box.body);
}

// Newton's method needs both tangents; it hangs less far than without skin and comes back.
TEST(Skin, ABodyThatHangsInItsSkinIsUnloadedAgain) {
  for (const ElementType type : {ElementType::linear, ElementType::quadratic}) {
    StaticBox bare({3, 3, 3}, {60., 60., 60.}, type, lame_parameters(400., 0.45)),
        box({3, 3, 3}, {60., 60., 60.}, type, with_skin());
    bare.load();
    EXPECT_TRUE(box.load().converged);
    const double sag = mean_sag(box);
    EXPECT_LT(sag, 0.95 * mean_sag(bare));
    EXPECT_GT(sag, 2.);
    const NodeVector x = box.loaded();
    NodeVector X = x;
    X.update_ghost_values();
    const QuasiStaticResult result = box.solver.unload(x, X);
    EXPECT_TRUE(result.converged);
    EXPECT_LT(largest_difference(X, box.body.vertex_positions()), 1e-5);
  }
}

} // namespace
} // namespace prosup::tests
