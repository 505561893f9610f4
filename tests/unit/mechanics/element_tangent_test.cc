#include "mechanics/element/element_tangent.h"

#include <gtest/gtest.h>

#include <cmath>

#include "all_laws.h"
#include "prosup/core/tet_topology.h"
#include "prosup/mechanics/laws/stress.h"

namespace prosup::tests {
namespace {

using namespace dealii;
using namespace prosup::mechanics;

constexpr LameParameters lame{200., 700.};
constexpr double pressure = 90.; // Pa, in addition to that of the law

/// A tetrahedron with bent edges, unloaded and loaded.
struct Tetrahedron {
  ElementVector X, x;

  Tetrahedron() {
    X[0] = Tensor<1, 3>({0.1, -0.2, 0.3});
    X[1] = Tensor<1, 3>({4.2, 0.1, 0.2});
    X[2] = Tensor<1, 3>({0.5, 5.1, -0.3});
    X[3] = Tensor<1, 3>({0.7, 0.9, 4.6});
    for (unsigned e = 0; e < 6; ++e) {
      X[4 + e] = 0.5 * (X[tet_edges[e][0]] + X[tet_edges[e][1]]);
      X[4 + e][e % 3] += 0.1 * std::sin(e + 1.);
    }
    for (unsigned a = 0; a < 10; ++a)
      for (unsigned c = 0; c < 3; ++c)
        x[a][c] = 1.1 * X[a][c] + 0.25 * X[a][(c + 1) % 3] + 0.15 * std::sin(3. * a + c);
  }
};

PointResponse response_of(const Law& law, const PointKinematics& point) {
  return std::visit([&](const auto& of) { return response(of, lame, point.F, point.jacobian); },
                    law);
}

ElementVector force_of(ElementType type, const Law& law, const Tetrahedron& tetrahedron) {
  const ElementShape& shape = element_shape(type);
  ElementVector force;
  for (unsigned q = 0; q < shape.n_points; ++q) {
    const PointKinematics point = point_kinematics(shape, q, tetrahedron.X, tetrahedron.x);
    add_internal_force(point, shape.n_nodes, response_of(law, point).stress, pressure, force);
  }
  return force;
}

/// Energy whose derivative by x the force is: p does work on the volume.
double energy_of(ElementType type, const Law& law, const Tetrahedron& tetrahedron) {
  const ElementShape& shape = element_shape(type);
  double energy = 0.;
  for (unsigned q = 0; q < shape.n_points; ++q) {
    const PointKinematics point = point_kinematics(shape, q, tetrahedron.X, tetrahedron.x);
    energy += point.volume * (energy_density(point.F, lame, law) + pressure * point.jacobian);
  }
  return energy;
}

constexpr double step = 1e-6;

/// Largest difference between a tangent and central differences of the force,
/// over the largest entry.
double tangent_error(ElementType type, const Law& law, ElementMatrix& tangent,
                     ElementVector Tetrahedron::*moves) {
  double difference = 0., scale = 0.;
  for (unsigned b = 0; b < tangent.n_nodes; ++b)
    for (unsigned j = 0; j < 3; ++j) {
      Tetrahedron plus, minus;
      (plus.*moves)[b][j] += step;
      (minus.*moves)[b][j] -= step;
      const ElementVector high = force_of(type, law, plus), low = force_of(type, law, minus);
      for (unsigned a = 0; a < tangent.n_nodes; ++a)
        for (unsigned i = 0; i < 3; ++i) {
          const double expected = (high[a][i] - low[a][i]) / (2. * step);
          difference = std::max(difference, std::abs(expected - tangent(a, i, b, j)));
          scale = std::max(scale, std::abs(expected));
        }
    }
  return difference / scale;
}

class ElementTangent : public ::testing::TestWithParam<std::tuple<ElementType, unsigned>> {
protected:
  const ElementType type = std::get<0>(GetParam());
  const Law law = all_laws()[std::get<1>(GetParam())];
  const ElementShape& shape = element_shape(type);
  Tetrahedron tetrahedron;
  ElementMatrix tangent;

  template <typename Add>
  void at_points(const Add& add) {
    tangent.reset(shape.n_nodes);
    for (unsigned q = 0; q < shape.n_points; ++q)
      add(point_kinematics(shape, q, tetrahedron.X, tetrahedron.x));
  }
};

TEST_P(ElementTangent, ForceIsTheDerivativeOfTheEnergy) {
  const ElementVector force = force_of(type, law, tetrahedron);
  double scale = 0.;
  for (unsigned a = 0; a < shape.n_nodes; ++a)
    scale = std::max(scale, force[a].norm());
  for (unsigned a = 0; a < shape.n_nodes; ++a)
    for (unsigned i = 0; i < 3; ++i) {
      Tetrahedron plus, minus;
      plus.x[a][i] += step;
      minus.x[a][i] -= step;
      const double expected =
          (energy_of(type, law, plus) - energy_of(type, law, minus)) / (2. * step);
      EXPECT_NEAR(force[a][i], expected, 1e-7 * scale) << a << " " << i;
    }
}

TEST_P(ElementTangent, ByLoadedPositionsEqualsDifferencesAndIsSymmetric) {
  at_points([&](const PointKinematics& point) {
    add_tangent_by_loaded(point, response_of(law, point), pressure, tangent);
  });
  EXPECT_LT(tangent_error(type, law, tangent, &Tetrahedron::x), 1e-8);
  for (unsigned a = 0; a < shape.n_nodes; ++a)
    for (unsigned b = 0; b < a; ++b)
      for (unsigned i = 0; i < 3; ++i)
        for (unsigned j = 0; j < 3; ++j)
          EXPECT_NEAR(tangent(a, i, b, j), tangent(b, j, a, i), 1e-9);
}

TEST_P(ElementTangent, ByUnloadedPositionsEqualsDifferences) {
  at_points([&](const PointKinematics& point) {
    add_tangent_by_unloaded(point, response_of(law, point), tangent);
  });
  EXPECT_LT(tangent_error(type, law, tangent, &Tetrahedron::X), 1e-8);
}

TEST_P(ElementTangent, InvertedElementsAreSeen) {
  for (const bool unloaded : {true, false}) {
    Tetrahedron inverted;
    (unloaded ? inverted.X : inverted.x)[3] = Tensor<1, 3>({0.7, 0.9, -9.});
    double min_jacobian = 1.;
    for (unsigned q = 0; q < shape.n_points; ++q)
      min_jacobian =
          std::min(min_jacobian, point_kinematics(shape, q, inverted.X, inverted.x).jacobian);
    EXPECT_LT(min_jacobian, 0.);
  }
}

INSTANTIATE_TEST_SUITE_P(Elements, ElementTangent,
                         ::testing::Combine(::testing::Values(ElementType::linear,
                                                              ElementType::quadratic),
                                            ::testing::Range(0u, unsigned(law_names().size()))));

} // namespace
} // namespace prosup::tests
