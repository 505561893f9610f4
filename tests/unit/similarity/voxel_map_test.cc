#include "prosup/similarity/voxel_map.h"

#include <deal.II/base/mpi.h>
#include <gtest/gtest.h>

#include "textured_pair.h"

namespace prosup::tests {
namespace {

using namespace dealii;
using similarity::VoxelMap;

Point<3> sheared(const Point<3>& X) {
  return Point<3>(X[0] + 0.2 * X[1] + 3., 1.1 * X[1] - 2., X[2] - 0.1 * X[0]);
}

mechanics::NodeVector displacement_of(const TexturedPair& pair) {
  mechanics::NodeVector u = pair.unloaded.prone;
  for (unsigned i = 0; i < 3 * pair.bodies.prone->n_local_nodes(); ++i)
    u.local_element(i) = pair.bodies.prone->vertex_positions().local_element(i) -
                         pair.unloaded.prone.local_element(i);
  return u;
}

TEST(VoxelMap, EveryVoxelOfTheBoxBelongsToOneRank) {
  const TexturedPair pair(sheared, sheared);
  const auto domain = TexturedPair::domain(1., 0);
  const VoxelMap map(domain.grid, *pair.bodies.prone, pair.unloaded.prone, 0);
  std::vector<int> owners(domain.grid.n_voxels(), 0);
  for (const auto& voxel : map.voxels()) {
    ++owners[voxel.index];
    EXPECT_FALSE(voxel.beyond_boundary);
    EXPECT_NEAR(voxel.weights[0] + voxel.weights[1] + voxel.weights[2] + voxel.weights[3], 1.,
                1e-5);
  }
  MPI_Allreduce(MPI_IN_PLACE, owners.data(), static_cast<int>(owners.size()), MPI_INT, MPI_SUM,
                MPI_COMM_WORLD);
  std::size_t v = 0;
  for (std::size_t k = 0; k < domain.grid.size[2]; ++k)
    for (std::size_t j = 0; j < domain.grid.size[1]; ++j)
      for (std::size_t i = 0; i < domain.grid.size[0]; ++i, ++v) {
        const Point<3> X = domain.grid.physical(double(i), double(j), double(k));
        const bool inside =
            X[0] >= 0. && X[0] <= 40. && X[1] >= 0. && X[1] <= 48. && X[2] >= 0. && X[2] <= 56.;
        ASSERT_EQ(owners[v], inside ? 1 : 0) << X;
      }
}

TEST(VoxelMap, FollowsAnAffineDeformationExactly) {
  const TexturedPair pair(sheared, sheared);
  const auto domain = TexturedPair::domain(2., 0);
  const VoxelMap map(domain.grid, *pair.bodies.prone, pair.unloaded.prone, 0);
  const mechanics::NodeVector u = displacement_of(pair);
  for (const auto& voxel : map.voxels()) {
    const auto& size = domain.grid.size;
    const Point<3> X =
        domain.grid.physical(double(voxel.index % size[0]), double(voxel.index / size[0] % size[1]),
                             double(voxel.index / (size[0] * size[1])));
    EXPECT_LT(map.loaded_position(voxel, u).distance(sheared(X)), 1e-4);
  }
}

TEST(VoxelMap, LayersSurroundTheMesh) {
  const TexturedPair pair(sheared, sheared);
  const auto domain = TexturedPair::domain(2., 0);
  const auto count = [&](unsigned n_layers) {
    const VoxelMap map(domain.grid, *pair.bodies.prone, pair.unloaded.prone, n_layers);
    unsigned n = 0;
    for (const auto& voxel : map.voxels()) {
      n += voxel.beyond_boundary;
      for (const float w : voxel.weights)
        if (voxel.beyond_boundary) {
          EXPECT_GE(w, 0.f);
        }
    }
    return Utilities::MPI::sum(n, MPI_COMM_WORLD);
  };
  const unsigned faces = 2 * (21 * 25 + 25 * 29 + 21 * 29);
  EXPECT_EQ(count(0), 0u);
  EXPECT_EQ(count(1), faces);
  EXPECT_GT(count(2), 2 * faces);
}

} // namespace
} // namespace prosup::tests
