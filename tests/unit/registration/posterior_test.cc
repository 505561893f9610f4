#include "registration/posterior.h"

#include <deal.II/base/mpi.h>
#include <gtest/gtest.h>

#include <cmath>

#include "box.h"

namespace prosup::tests {
namespace {

using namespace dealii;
using namespace prosup::registration;
using mechanics::CellStiffness;
using mechanics::NodeVector;

constexpr mechanics::LameParameters lame{300., 1200.};
constexpr double factor = 3.;
constexpr unsigned n_samples = 1000;

/// A box of tissue on springs, and images that see its displacement along x in half of its cells.
struct Box {
  std::unique_ptr<Distributed> mesh;
  mechanics::Body body;
  mechanics::Supports supports{body};
  mechanics::Material material{lame, mechanics::NeoHookean()};
  NodeVector unloaded;
  std::vector<CellStiffness> images;

  explicit Box(MPI_Comm communicator = MPI_COMM_WORLD)
      : mesh(make_box(communicator, {2, 2, 3}, Point<3>(20., 20., 30.))), body(*mesh),
        unloaded(body.vertex_positions()) {
    unloaded.update_ghost_values();
    supports.add_springs({0, 1, 2, 3, 4, 5}, 5.);
    supports.set_reference(unloaded);
    for (const auto& cell : body.cells()) {
      const bool sees = mechanics::node_value(unloaded, cell[0])[2] < 15.;
      CellStiffness stiffness;
      unsigned pair = 0;
      for (unsigned a = 0; a < 4; ++a)
        for (unsigned b = a; b < 4; ++b, ++pair)
          stiffness[pair][0][0] = sees ? (a == b ? 2. : 1.) * 5000. : 0.;
      images.push_back(stiffness);
    }
  }

  PosteriorBody posterior_body() const { return {supports, material, unloaded}; }

  /// The diagonal blocks of the inverse, one solution for each column.
  std::vector<NodeCovariance> exact(const std::vector<CellStiffness>& added) const {
    const mechanics::ElasticMetric metric(supports, material, unloaded);
    std::vector<NodeCovariance> blocks(body.n_owned_nodes());
    const IndexSet owned = body.vertex_positions().locally_owned_elements();
    for (unsigned column = 0; column < body.vertex_positions().size(); ++column) {
      NodeVector force, u;
      body.initialize(force);
      if (owned.is_element(column))
        force(column) = 1.;
      metric.solve(added, factor, force, 1e-10, u);
      if (owned.is_element(column)) {
        const auto index = static_cast<unsigned>(owned.index_within_set(column));
        for (unsigned c = 0; c <= index % 3; ++c)
          blocks[index / 3][c][index % 3] = u.local_element(3 * (index / 3) + c);
      }
    }
    return blocks;
  }
};

void expect_sampled(const std::vector<CellStiffness>& images) {
  const Box box;
  const auto exact = box.exact(images);
  const auto sampled = sampled_inverse(box.posterior_body(), images, factor, n_samples);
  ASSERT_EQ(sampled.size(), exact.size());
  for (unsigned node = 0; node < exact.size(); ++node)
    EXPECT_LT((sampled[node] - exact[node]).norm(), 0.2 * exact[node].norm()) << node;
}

TEST(Posterior, SampledCovarianceIsTheInverseStiffness) {
  expect_sampled({});
  expect_sampled(Box().images);
}

TEST(Posterior, ImagesTakeUncertaintyAwayWhereTheySee) {
  const Box box;
  const auto before = sampled_inverse(box.posterior_body(), {}, factor, 100),
             after = sampled_inverse(box.posterior_body(), box.images, factor, 100);
  for (unsigned node = 0; node < before.size(); ++node) {
    const double z = mechanics::node_value(box.unloaded, node)[2];
    if (z < 5.) {
      EXPECT_LT(after[node][0][0], 0.3 * before[node][0][0]); // along the gradient
      EXPECT_GT(after[node][1][1], 0.4 * before[node][1][1]); // across it
    } else if (z > 25.) {
      EXPECT_GT(after[node][0][0], 0.4 * before[node][0][0]);
    }
  }
}

double sum_of_variances(const Box& box) {
  double sum = 0.;
  for (const NodeCovariance& block : sampled_inverse(box.posterior_body(), box.images, factor, 8))
    sum += trace(block);
  return Utilities::MPI::sum(sum, box.body.communicator());
}

TEST(Posterior, DoesNotDependOnTheNumberOfRanks) {
  const double alone = sum_of_variances(Box(MPI_COMM_SELF));
  EXPECT_NEAR(sum_of_variances(Box()), alone, 0.02 * alone); // the tolerance of the solver
}

} // namespace
} // namespace prosup::tests
