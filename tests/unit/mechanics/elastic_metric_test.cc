#include "prosup/mechanics/static/elastic_metric.h"

#include <gtest/gtest.h>

#include <cmath>

#include "all_laws.h"
#include "box.h"

namespace prosup::tests {
namespace {

using namespace dealii;
using namespace prosup::mechanics;

const Point<3> size(30., 20., 25.);
constexpr LameParameters lame{300., 1200.};

struct Box {
  explicit Box(const BoundaryIds& fixed)
      : mesh(make_box(MPI_COMM_WORLD, {4, 3, 4}, size)), body(*mesh), supports(body, fixed) {
    unloaded = body.vertex_positions();
    unloaded.update_ghost_values();
    supports.set_reference(unloaded);
  }

  template <typename Field>
  NodeVector field(Field value) const {
    NodeVector result;
    body.initialize(result);
    for (unsigned node = 0; node < body.n_owned_nodes(); ++node) {
      const Tensor<1, 3> v = value(node_value(body.vertex_positions(), node));
      for (unsigned c = 0; c < 3; ++c)
        result.local_element(3 * node + c) = v[c];
    }
    return result;
  }

  ElasticMetric metric(const Law& law = NeoHookean()) const {
    return ElasticMetric(supports, {lame, law}, unloaded);
  }

  std::unique_ptr<Triangulation<3>> mesh;
  Body body;
  Supports supports;
  NodeVector unloaded;
};

Tensor<1, 3> wavy(const Tensor<1, 3>& x) {
  return Tensor<1, 3>({std::sin(0.3 * x[1]), std::cos(0.2 * x[2] + x[0]), 0.1 * x[0]});
}

TEST(ElasticMetric, EnergyOfAHomogeneousStrain) {
  const Box box({});
  Tensor<2, 3> gradient;
  gradient[0][0] = 0.1;
  gradient[0][1] = 0.05;
  gradient[1][2] = -0.2;
  gradient[2][2] = 0.07;
  const NodeVector u = box.field([&](const Tensor<1, 3>& x) { return gradient * x; });
  NodeVector force;
  box.body.initialize(force);
  const SymmetricTensor<2, 3> strain = symmetrize(gradient);
  const double density =
      lame.mu * (strain * strain) + 0.5 * lame.lambda * trace(strain) * trace(strain);
  for (const Law& law : all_laws()) {
    box.metric(law).multiply(u, force);
    EXPECT_NEAR(0.5 * (force * u), density * size[0] * size[1] * size[2],
                1e-9 * std::abs(force * u))
        << name_of(law);
  }
}

TEST(ElasticMetric, DoesNotFeelRotations) {
  const Box box({});
  const NodeVector u = box.field([&](const Tensor<1, 3>& x) {
    return Tensor<1, 3>({1. - x[1], x[0], 2.});
  });
  NodeVector force;
  box.body.initialize(force);
  box.metric().multiply(u, force);
  EXPECT_LT(force.linfty_norm(), 1e-9);
}

TEST(ElasticMetric, SolvesForTheDisplacementUnderItsForce) {
  const Box box({3});
  NodeVector u = box.field(wavy), force, found;
  box.supports.project(u);
  box.body.initialize(force);
  box.metric().multiply(u, force);
  EXPECT_GT(box.metric().solve({}, 1., force, 1e-10, found), 5u);
  found -= u;
  EXPECT_LT(found.linfty_norm(), 1e-7);
}

TEST(ElasticMetric, AddedStiffnessActsWhereItIs) {
  // A stiffness s V I on all cells, lumped to their corners, against K + s M.
  const Box box({3});
  std::vector<CellStiffness> cells(box.body.cells().size());
  constexpr double s = 7.;
  for (CellStiffness& cell : cells)
    for (const unsigned diagonal : {0u, 4u, 7u, 9u})
      cell[diagonal] = s * unit_symmetric_tensor<3>();
  NodeVector u = box.field(wavy), force, found;
  box.supports.project(u);
  box.body.initialize(force);
  box.metric().multiply(u, force);
  std::vector<double> n_cells_at(box.body.n_local_nodes(), 0.);
  for (const auto& cell : box.body.cells())
    for (const unsigned node : cell)
      n_cells_at[node] += 1.;
  n_cells_at = sum_over_ranks(box.body, n_cells_at);
  constexpr double factor = 3.;
  for (unsigned node = 0; node < box.body.n_owned_nodes(); ++node)
    for (unsigned c = 0; c < 3; ++c)
      force.local_element(3 * node + c) +=
          factor * s * n_cells_at[node] * u.local_element(3 * node + c);
  box.metric().solve(cells, factor, force, 1e-10, found);
  found -= u;
  EXPECT_LT(found.linfty_norm(), 1e-7);
}

} // namespace
} // namespace prosup::tests
