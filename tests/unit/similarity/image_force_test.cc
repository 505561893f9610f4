#include "prosup/similarity/image_force.h"

#include <deal.II/base/mpi.h>
#include <gtest/gtest.h>

#include "prosup/image/sampling.h"
#include "prosup/similarity/domain.h"
#include "prosup/similarity/sum_of_squared_differences.h"
#include "prosup/similarity/voxel_map.h"
#include "textured_pair.h"

namespace prosup::tests {
namespace {

using namespace dealii;
using mechanics::node_value;
using similarity::ImageForce;
using similarity::SimilarityResult;

std::shared_ptr<const similarity::Metric> ssd() {
  return std::make_shared<similarity::SumOfSquaredDifferences>();
}

Point<3> stretched(const Point<3>& X) {
  return Point<3>(X[0] + 2. * std::sin(0.05 * X[1]), 1.15 * X[1], X[2] - 0.002 * X[1] * X[2]);
}

Point<3> flattened(const Point<3>& X) {
  return Point<3>(1.05 * X[0] - 1., 0.85 * X[1], X[2] + 1.5 * std::sin(0.06 * X[0]));
}

/// A smooth direction in which the loaded nodes are moved.
Tensor<1, 3> direction(const Point<3>& X) {
  return Tensor<1, 3>({std::sin(0.08 * X[1] + 0.3), std::cos(0.07 * X[2]), 0.5 - 0.02 * X[0]});
}

/// The same for unloaded nodes inside the box: voxels that enter or leave the body
/// change the value by steps.
Tensor<1, 3> direction_inside(const Point<3>& X) {
  return std::sin(numbers::PI * X[0] / 40.) * std::sin(numbers::PI * X[1] / 48.) *
         std::sin(numbers::PI * X[2] / 56.) * direction(X);
}

double value_moved(Position position, double distance, unsigned n_layers) {
  const auto moved = [&](const TexturedPair::Map& map) {
    return [=](const Point<3>& X) { return map(X) + distance * direction(X); };
  };
  const TexturedPair pair(
      position == Position::prone ? moved(stretched) : TexturedPair::Map(stretched),
      position == Position::supine ? moved(flattened) : TexturedPair::Map(flattened));
  return ImageForce(ssd(), MPI_COMM_WORLD)
      .evaluate(TexturedPair::domain(2., n_layers), pair.imaged())
      .value;
}

TEST(ImageForce, IsMinusTheDerivativeOfTheSsd) {
  const TexturedPair pair(stretched, flattened);
  for (const unsigned n_layers : {0u, 2u}) {
    const SimilarityResult result =
        ImageForce(ssd(), MPI_COMM_WORLD)
            .evaluate(TexturedPair::domain(2., n_layers), pair.imaged());
    for (const Position position : both_positions) {
      double work = 0.;
      for (unsigned node = 0; node < pair.bodies[position]->n_owned_nodes(); ++node)
        work += node_value(result.forces[position], node) *
                direction(Point<3>(node_value(pair.unloaded[position], node)));
      work = Utilities::MPI::sum(work, MPI_COMM_WORLD);
      const double step = 1e-3;
      const double slope =
          (value_moved(position, step, n_layers) - value_moved(position, -step, n_layers)) /
          (2. * step);
      EXPECT_NEAR(work, -slope, 2e-3 * std::abs(slope)) << name_of(position);
      EXPECT_GT(std::abs(slope), 1.);
    }
  }
}

TEST(ImageForce, ByUnloadedPositionsIsMinusTheDerivativeOfTheSsd) {
  const auto value_moved_unloaded = [](Position position, double distance) {
    TexturedPair pair(stretched, flattened);
    for (unsigned node = 0; node < pair.bodies[position]->n_local_nodes(); ++node) {
      const Tensor<1, 3> way =
          direction_inside(Point<3>(node_value(pair.unloaded[position], node)));
      for (unsigned c = 0; c < 3; ++c)
        pair.unloaded[position].local_element(3 * node + c) += distance * way[c];
    }
    return ImageForce(ssd(), MPI_COMM_WORLD).value(TexturedPair::domain(2., 0), pair.imaged());
  };
  const TexturedPair pair(stretched, flattened);
  const SimilarityResult result =
      ImageForce(ssd(), MPI_COMM_WORLD)
          .evaluate(TexturedPair::domain(2., 0), pair.imaged(), similarity::Variable::unloaded);
  for (const Position position : both_positions) {
    double work = 0.;
    for (unsigned node = 0; node < pair.bodies[position]->n_owned_nodes(); ++node)
      work += node_value(result.forces[position], node) *
              direction_inside(Point<3>(node_value(pair.unloaded[position], node)));
    work = Utilities::MPI::sum(work, MPI_COMM_WORLD);
    const double step = 1e-3;
    const double slope =
        (value_moved_unloaded(position, step) - value_moved_unloaded(position, -step)) /
        (2. * step);
    EXPECT_NEAR(work, -slope, 0.02 * std::abs(slope)) << name_of(position);
    EXPECT_GT(std::abs(slope), 1.);
  }
}

TEST(ImageForce, StiffnessIsTheSquareOfTheGradients) {
  // d^T H d = sum_v h^3 (grad P . d)^2 = what the residual changes by, squared.
  const TexturedPair pair(stretched, stretched);
  const auto domain = TexturedPair::domain(2., 0);
  const ImageForce force(ssd(), MPI_COMM_WORLD);
  const SimilarityResult result =
      force.evaluate(domain, pair.imaged(), similarity::Variable::displacement, true);
  const double step = 1e-3;
  const TexturedPair moved([=](const Point<3>& X) { return stretched(X) + step * direction(X); },
                           stretched);
  const auto before = force.residuals(domain, pair.imaged()),
             after = force.residuals(domain, moved.imaged());
  double expected = 0., found = 0.;
  for (std::size_t v = 0; v < before.size(); ++v)
    expected += std::pow((after[v] - before[v]) / step, 2);
  for (std::size_t cell = 0; cell < result.stiffness.prone.size(); ++cell) {
    unsigned entry = 0;
    for (unsigned a = 0; a < 4; ++a)
      for (unsigned b = a; b < 4; ++b, ++entry) {
        const auto way = [&](unsigned corner) {
          return direction(
              Point<3>(node_value(pair.unloaded.prone, pair.bodies.prone->cells()[cell][corner])));
        };
        found += (a == b ? 1. : 2.) * (way(a) * (result.stiffness.prone[cell][entry] * way(b)));
      }
  }
  EXPECT_NEAR(Utilities::MPI::sum(found, MPI_COMM_WORLD), expected, 0.01 * expected);
}

TEST(ImageForce, NodalForcesSumToTheVoxelForces) {
  const TexturedPair pair(stretched, flattened);
  const auto domain = TexturedPair::domain(2., 1);
  const ImageForce force(ssd(), MPI_COMM_WORLD);
  const auto bodies = pair.imaged();
  const SimilarityResult result = force.evaluate(domain, bodies);
  const auto warped = force.warp(domain, bodies);
  for (const Position position : both_positions) {
    Tensor<1, 3> nodal, voxels;
    for (unsigned node = 0; node < pair.bodies[position]->n_owned_nodes(); ++node)
      nodal += node_value(result.forces[position], node);
    const similarity::VoxelMap map(domain.grid, *pair.bodies[position], pair.unloaded[position],
                                   domain.n_layers);
    mechanics::NodeVector u = pair.unloaded[position];
    for (unsigned i = 0; i < 3 * pair.bodies[position]->n_local_nodes(); ++i)
      u.local_element(i) = pair.bodies[position]->vertex_positions().local_element(i) -
                           pair.unloaded[position].local_element(i);
    const image::Sampler sampler(pair.images[position]);
    for (const auto& voxel : map.voxels()) {
      Tensor<1, 3> gradient;
      sampler.value_and_gradient(map.loaded_position(voxel, u), gradient);
      const double difference =
          warped.values[position][voxel.index] - warped.values[other(position)][voxel.index];
      if (warped.in_domain[voxel.index])
        voxels -= domain.grid.voxel_volume() * difference * gradient;
    }
    for (unsigned c = 0; c < 3; ++c) {
      const double sum = Utilities::MPI::sum(voxels[c], MPI_COMM_WORLD);
      EXPECT_NEAR(Utilities::MPI::sum(nodal[c], MPI_COMM_WORLD), sum, 1e-4 * (1. + std::abs(sum)));
    }
  }
}

TEST(ImageForce, ExcludedRegionsDoNotCount) {
  const TexturedPair pair(stretched, flattened);
  const ImageForce force(ssd(), MPI_COMM_WORLD);
  auto domain = TexturedPair::domain(2., 1);
  const double all = force.value(domain, pair.imaged());
  PerPosition<image::LabelImage> excluded;
  domain.excluded = &excluded; // both empty: nothing is excluded
  EXPECT_EQ(force.value(domain, pair.imaged()), all);
  excluded.supine = image::LabelImage(pair.images.supine.grid, 0);
  for (std::size_t v = 0; v < excluded.supine.values.size() / 2; ++v)
    excluded.supine.values[v] = 1;
  const double part = force.value(domain, pair.imaged());
  EXPECT_LT(part, 0.9 * all);
  EXPECT_GT(part, 0.1 * all);
  excluded.prone = image::LabelImage(pair.images.prone.grid, 1);
  const SimilarityResult nothing = force.evaluate(domain, pair.imaged());
  EXPECT_EQ(nothing.value, 0.);
  EXPECT_EQ(nothing.forces.prone.linfty_norm(), 0.);
}

TEST(ImageForce, VanishesWhereTheImagesAgree) {
  TexturedPair pair(stretched, stretched);
  pair.images.supine = pair.images.prone;
  const SimilarityResult result =
      ImageForce(ssd(), MPI_COMM_WORLD).evaluate(TexturedPair::domain(2., 2), pair.imaged());
  EXPECT_NEAR(result.value, 0., 1e-9);
  EXPECT_NEAR(result.forces.prone.linfty_norm(), 0., 1e-9);
  EXPECT_NEAR(result.forces.supine.linfty_norm(), 0., 1e-9);
}

TEST(ImageForce, SwappingThePositionsSwapsTheForces) {
  TexturedPair pair(stretched, flattened), swapped(flattened, stretched);
  std::swap(swapped.images.prone, swapped.images.supine);
  const ImageForce force(ssd(), MPI_COMM_WORLD);
  const auto domain = TexturedPair::domain(2., 2);
  const SimilarityResult a = force.evaluate(domain, pair.imaged());
  const SimilarityResult b = force.evaluate(domain, swapped.imaged());
  EXPECT_NEAR(a.value, b.value, 1e-9 * a.value);
  for (unsigned i = 0; i < 3 * pair.bodies.prone->n_owned_nodes(); ++i) {
    EXPECT_NEAR(a.forces.prone.local_element(i), b.forces.supine.local_element(i), 1e-6);
    EXPECT_NEAR(a.forces.supine.local_element(i), b.forces.prone.local_element(i), 1e-6);
  }
}

TEST(Domain, ChestAndTouchedBordersAreNoAir) {
  similarity::Scene scene;
  image::VoxelGrid grid;
  grid.size = {10, 10, 10};
  for (image::LabelImage* image : {&scene.labels.prone, &scene.labels.supine}) {
    image::LabelImage& labels = *image;
    labels = image::LabelImage(grid, 0);
    for (std::size_t i = 0; i < 10; ++i) // chest at low y touches the ends of x
      labels(i, 2, 5) = 1;
  }
  const auto around = image::grid_around(Point<3>(), Point<3>(9., 9., 9.), 1., 3.); // from -3 to 12
  const auto domain = similarity::similarity_domain(around, scene, 1);
  const auto no_air = [&](double x, double y, double z) {
    const Point<3> i = around.continuous_index(Point<3>(x, y, z));
    return bool(domain.no_air[around.linear_index(std::size_t(i[0] + 0.5), std::size_t(i[1] + 0.5),
                                                  std::size_t(i[2] + 0.5))]);
  };
  EXPECT_TRUE(no_air(4., 2., 5.));
  EXPECT_FALSE(no_air(4., 7., 5.));
  EXPECT_TRUE(no_air(-2., 7., 5.));  // tissue may go on there
  EXPECT_FALSE(no_air(4., 11., 5.)); // nothing touches that border: air
}

} // namespace
} // namespace prosup::tests
