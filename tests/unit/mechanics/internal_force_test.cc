#include "prosup/mechanics/body/boundary.h"
#include "prosup/mechanics/element/internal_force.h"

#include <deal.II/base/mpi.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "all_laws.h"
#include "box.h"
#include "prosup/mechanics/laws/stress.h"

namespace prosup::tests {
namespace {

using namespace dealii;
using namespace prosup::mechanics;

/// A box mesh with its kernel, and nodal fields given as functions of X.
struct Fixture {
  std::unique_ptr<Distributed> mesh = make_box(MPI_COMM_WORLD, {3, 4, 5}, {30., 40., 50.});
  Body body{*mesh};
  InternalForce kernel{body};
  Material material{lame_parameters(300., 0.45)};

  Fixture() {
    kernel.set_material(material);
    kernel.set_reference(body.vertex_positions());
  }

  template <typename Function>
  NodeVector field(Function function) const {
    NodeVector values;
    body.initialize(values);
    for (unsigned node = 0; node < body.n_local_nodes(); ++node) {
      const Tensor<1, 3> value = function(node_value(body.vertex_positions(), node));
      for (unsigned c = 0; c < 3; ++c)
        values.local_element(3 * node + c) = value[c];
    }
    values.update_ghost_values();
    return values;
  }

  NodeVector force(const NodeVector& displacement) const {
    NodeVector result;
    body.initialize(result);
    kernel.subtract(displacement, result);
    return result;
  }

  /// The same, cell by cell with the tensor formula.
  NodeVector plain_force(const NodeVector& displacement) const {
    NodeVector result;
    body.initialize(result);
    for (std::size_t cell = 0; cell < body.cells().size(); ++cell) {
      Tensor<2, 3> D, E;
      for (unsigned b = 0; b < 3; ++b)
        for (unsigned c = 0; c < 3; ++c) {
          const auto difference = [&](const NodeVector& v) {
            return v.local_element(3 * body.cells()[cell][b + 1] + c) -
                   v.local_element(3 * body.cells()[cell][0] + c);
          };
          D[c][b] = difference(body.vertex_positions());
          E[c][b] = difference(displacement);
        }
      Tensor<2, 3> F = E * invert(D);
      for (unsigned c = 0; c < 3; ++c)
        F[c][c] += 1.;
      const Tensor<2, 3> P = first_piola_kirchhoff_stress(F, material[cell], material.law());
      const double volume = determinant(D) / 6.;
      for (unsigned b = 0; b < 3; ++b) {
        const Tensor<1, 3> f = volume * (P * invert(D)[b]);
        for (unsigned c = 0; c < 3; ++c) {
          result.local_element(3 * body.cells()[cell][b + 1] + c) -= f[c];
          result.local_element(3 * body.cells()[cell][0] + c) += f[c];
        }
      }
    }
    result.compress(VectorOperation::add);
    return result;
  }
};

Tensor<1, 3> wave(const Tensor<1, 3>& X) {
  return Tensor<1, 3>({2. * std::sin(0.1 * X[1]), 3. * std::cos(0.08 * X[2] + 0.05 * X[0]),
                       2.5 * std::sin(0.07 * X[0] + 0.1 * X[2])});
}

double relative_difference(const NodeVector& a, const NodeVector& b) {
  NodeVector difference = a;
  difference -= b;
  return difference.l2_norm() / b.l2_norm();
}

TEST(InternalForce, RigidMotionGivesNoForce) {
  Fixture f;
  const double angle = 0.7;
  const NodeVector rotated = f.field([&](const Tensor<1, 3>& X) {
    return Tensor<1, 3>({std::cos(angle) * X[0] - std::sin(angle) * X[1] - X[0] + 5.,
                         std::sin(angle) * X[0] + std::cos(angle) * X[1] - X[1] - 3., 2.});
  });
  const double scale = f.force(f.field(wave)).linfty_norm();
  EXPECT_LT(f.force(rotated).linfty_norm(), 1e-11 * scale);
}

TEST(InternalForce, BatchKernelEqualsTensorFormula) {
  Fixture f;
  for (const Law& law : all_laws()) {
    f.material = {lame_parameters(300., 0.45), law};
    f.kernel.set_material(f.material);
    const NodeVector u = f.field(wave);
    EXPECT_LT(relative_difference(f.force(u), f.plain_force(u)), 1e-12) << name_of(law);
  }
}

TEST(InternalForce, MaterialOfEachCell) {
  Fixture f;
  std::vector<LameParameters> of_cells;
  for (std::size_t cell = 0; cell < f.body.cells().size(); ++cell)
    of_cells.push_back(lame_parameters(100. + 10. * static_cast<double>(cell), 0.3));
  f.material = of_cells;
  f.kernel.set_material(f.material);
  const NodeVector u = f.field(wave);
  EXPECT_LT(relative_difference(f.force(u), f.plain_force(u)), 1e-12);
}

TEST(InternalForce, ForcesBalance) {
  Fixture f;
  const NodeVector force = f.force(f.field(wave));
  Tensor<1, 3> sum;
  for (unsigned node = 0; node < f.body.n_owned_nodes(); ++node)
    sum += node_value(force, node);
  for (unsigned c = 0; c < 3; ++c)
    EXPECT_NEAR(Utilities::MPI::sum(sum[c], MPI_COMM_WORLD), 0., 1e-9 * force.l2_norm());
}

TEST(InternalForce, SmallestJacobianAndWorstCell) {
  Fixture f;
  const NodeVector squeezed = f.field([](const Tensor<1, 3>& X) {
    return Tensor<1, 3>({-0.5 * X[0], 0., 0.});
  });
  NodeVector force;
  f.body.initialize(force);
  EXPECT_NEAR(f.kernel.subtract(squeezed, force), 0.5, 1e-12);

  // Volumes of the cells as they are, over those they had.
  NodeVector deformed = f.field(wave);
  deformed += f.body.vertex_positions();
  deformed.update_ghost_values();
  const auto volume = [&](const NodeVector& v, std::size_t cell) {
    const auto& nodes = f.body.cells()[cell];
    const Tensor<1, 3> origin = node_value(v, nodes[0]);
    return (node_value(v, nodes[1]) - origin) *
           cross_product_3d(node_value(v, nodes[2]) - origin, node_value(v, nodes[3]) - origin);
  };
  std::size_t worst = 0;
  const auto jacobian = [&](std::size_t cell) {
    return volume(deformed, cell) / volume(f.body.vertex_positions(), cell);
  };
  for (std::size_t cell = 0; cell < f.body.cells().size(); ++cell)
    if (jacobian(cell) < jacobian(worst))
      worst = cell;
  const auto found = f.kernel.worst_cell(f.body.vertex_positions(), f.field(wave));
  EXPECT_NEAR(found.jacobian, jacobian(worst), 1e-12);
  EXPECT_EQ(found.cell, f.body.cell_ids()[worst]);
}

TEST(InternalForce, LumpedVolumeIsTheVolume) {
  Fixture f;
  const std::vector<double> volume = f.kernel.lumped_volume();
  double sum = 0.;
  for (unsigned node = 0; node < f.body.n_owned_nodes(); ++node)
    sum += volume[node];
  EXPECT_NEAR(Utilities::MPI::sum(sum, MPI_COMM_WORLD), 60000., 1e-8);
}

TEST(Body, BoundaryNodesAndGatheredCells) {
  Fixture f;
  const std::vector<bool> low_x = nodes_on_boundary(f.body, {0});
  unsigned n = 0;
  for (unsigned node = 0; node < f.body.n_owned_nodes(); ++node) {
    EXPECT_EQ(low_x[node], std::abs(f.body.vertex_positions().local_element(3 * node)) < 1e-9);
    n += low_x[node];
  }
  EXPECT_EQ(Utilities::MPI::sum(n, MPI_COMM_WORLD), 5u * 6u);

  const auto corners = f.body.gather_at_cells(f.body.vertex_positions());
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0) {
    EXPECT_TRUE(corners.empty());
    return;
  }
  ASSERT_EQ(corners.size(), f.body.n_global_cells());
  double volume = 0.;
  for (const auto& c : corners)
    volume += std::abs(cross_product_3d(c[1] - c[0], c[2] - c[0]) * (c[3] - c[0])) / 6.;
  EXPECT_NEAR(volume, 60000., 1e-8);
}

} // namespace
} // namespace prosup::tests
