#include <deal.II/base/mpi.h>
#include <gtest/gtest.h>

#include <cmath>

#include "loaded_box.h"
#include "prosup/core/error.h"
#include "prosup/mesh/scan_conversion.h"
#include "prosup/registration/body_pair.h"
#include "prosup/registration/image_force_registration.h"
#include "prosup/registration/material_update.h"
#include "prosup/registration/similarity_setup.h"
#include "prosup/registration/simulated_bodies.h"

namespace prosup::tests {
namespace {

using namespace dealii;
using namespace prosup::registration;
using mechanics::node_value;
using similarity::prone;
using similarity::supine;

constexpr double true_shear_modulus = 300.; // Pa
const std::vector<unsigned> n_cells{5, 4, 5};
const Point<3> size(45., 32., 45.);
const Tensor<1, 3> gravity[2] = {Tensor<1, 3>({0., -1., 0.}), Tensor<1, 3>({0., 1., 0.})};

float texture(const Point<3>& X) {
  return float(0.5 + 0.25 * std::sin(0.25 * X[0]) * std::cos(0.3 * X[1]) +
               0.25 * std::cos(0.22 * X[2] + 0.1 * X[1]));
}

/// The same textured block hanging and standing on its upper face, as images,
/// with one body of each set up on the ranks of a split.
struct Scene {
  HangingBoxParameters parameters;
  const Labels labels;
  mechanics::TissueMaterial material{labels};
  similarity::SimilarityParameters similarity_parameters;
  RankSplit ranks{MPI_COMM_WORLD};
  BodyPair pair{ranks};
  similarity::Scene surroundings;

  Scene() {
    parameters.residual_tolerance = 1e-3;
    parameters.position_tolerance = 1e-2;
    const std::vector<mechanics::LameParameters> truth{
        mechanics::lame_parameters(true_shear_modulus, material.initial().poisson_ratio)};
    std::vector<LoadedBox> loaded;
    for (const unsigned s : {0u, 1u})
      loaded.emplace_back(n_cells, size, truth, parameters, gravity[s]);
    pair.for_each([&](State s, BodyState& state) {
      const auto mesh = make_box(ranks.group(), n_cells, size, loaded[s]);
      state.body = std::make_unique<mechanics::Body>(*mesh);
      state.supports =
          std::make_unique<mechanics::Supports>(*state.body, mechanics::BoundaryIds{3});
      state.unloading =
          std::make_unique<unloading::Unloading>(parameters, *state.supports, gravity[s]);
      state.image = image_of(loaded[s]);
    });
    for (image::LabelImage& labels : surroundings.labels)
      labels = image::LabelImage(grid(), 0);
  }

  static image::VoxelGrid grid() { return image::grid_around(Point<3>(), size, 1., 20.); }

  static image::ScalarImage image_of(const LoadedBox& box) {
    image::ScalarImage image(grid());
    for (std::size_t cell = 0; cell < box.after.size(); ++cell)
      mesh::scan_convert_tet(image.grid, box.after[cell],
                             [&](auto i, auto j, auto k, const auto& weights) {
                               Point<3> X;
                               for (unsigned a = 0; a < 4; ++a)
                                 X += weights[a] * Tensor<1, 3>(box.before[cell][a]);
                               image(i, j, k) = texture(X);
                             });
    return image;
  }

  void unload(double shear_modulus, double poisson_ratio = 0.4) {
    pair.set_properties(material, {{shear_modulus, poisson_ratio, 1.}, 0.});
    for (const auto& result : pair.unload())
      EXPECT_TRUE(result.converged);
  }

  /// Mean distance between the unloaded positions and the true block, mm.
  double error() {
    double sum = 0.;
    unsigned n = 0;
    pair.for_each([&](State, BodyState& state) {
      const auto mesh = make_box(ranks.group(), n_cells, size);
      const mechanics::Body block(*mesh); // the same topology has the same node numbers
      for (unsigned node = 0; node < block.n_owned_nodes(); ++node, ++n)
        sum += (node_value(state.unloading->unloaded(), node) -
                node_value(block.vertex_positions(), node))
                   .norm();
    });
    return Utilities::MPI::sum(sum, MPI_COMM_WORLD) / Utilities::MPI::sum(n, MPI_COMM_WORLD);
  }
};

TEST(RankSplit, SharesTheRanks) {
  const RankSplit ranks(MPI_COMM_WORLD);
  const unsigned n = Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
  for (const State state : {prone, supine})
    EXPECT_EQ(Utilities::MPI::sum(ranks.holds(state) ? 1u : 0u, MPI_COMM_WORLD),
              n == 1 ? 1u : (state == prone ? (n + 1) / 2 : n / 2));
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) ==
      static_cast<unsigned>(ranks.first_rank(supine))) {
    EXPECT_TRUE(ranks.holds(supine));
  }
}

TEST(BodyPair, AFailureOfOneStateIsTheFailureOfAll) {
  const RankSplit ranks(MPI_COMM_WORLD);
  BodyPair pair(ranks);
  EXPECT_THROW(pair.for_each([](State state, BodyState&) {
    if (state == supine)
      throw Error("only supine");
  }),
               Error);
}

template <typename Stage>
std::unique_ptr<Stage> configured(const std::vector<std::array<const char*, 2>>& entries) {
  auto stage = std::make_unique<Stage>();
  ParameterHandler prm;
  ParameterAcceptor::declare_all_parameters(prm);
  prm.enter_subsection(stage->get_section_name());
  for (const auto& [entry, value] : entries)
    prm.set(entry, value);
  prm.leave_subsection();
  ParameterAcceptor::parse_all_parameters(prm);
  return stage;
}

TEST(MaterialUpdate, StepwiseFindsTheShearModulusFromEitherSide) {
  Scene scene;
  const SimilaritySetup setup(scene.similarity_parameters, MPI_COMM_WORLD);
  const auto update = configured<MaterialUpdate>({{"Method", "stepwise"}, {"Levels", "2"}});
  for (const double factor : {1.1 * 1.1 * 1.1, 1. / (1.1 * 1.1)}) {
    scene.unload(factor * true_shear_modulus);
    const double before = scene.error();
    SimulatedBodies bodies(scene.pair, setup, scene.surroundings, scene.material);
    const auto result = update->run(bodies, setup.metric(), Log());
    EXPECT_NEAR(scene.pair.properties().tissue.shear_modulus, true_shear_modulus,
                0.051 * true_shear_modulus);
    EXPECT_TRUE(result.converged);
    EXPECT_LT(scene.error(), 0.2 * before);
  }
}

TEST(MaterialUpdate, SearchFindsBothElasticConstants) {
  Scene scene;
  const SimilaritySetup setup(scene.similarity_parameters, MPI_COMM_WORLD);
  const auto update = configured<MaterialUpdate>({{"Levels", "4, 2"}});
  for (const double factor : {1.7, 0.75}) {
    scene.unload(factor * true_shear_modulus, 0.34);
    const double before = scene.error();
    SimulatedBodies bodies(scene.pair, setup, scene.surroundings, scene.material);
    const auto result = update->run(bodies, setup.metric(), Log());
    const mechanics::TissueStiffness& found = scene.pair.properties().tissue;
    EXPECT_NEAR(found.shear_modulus, true_shear_modulus, 0.03 * true_shear_modulus);
    EXPECT_NEAR(found.poisson_ratio, 0.4, 0.015);
    EXPECT_EQ(found.gland_ratio, 1.); // there is none
    EXPECT_TRUE(result.converged);
    EXPECT_LT(result.n_trials, 40u);
    EXPECT_LT(scene.error(), 0.1 * before);
  }
}

TEST(ImageForceRegistration, BringsBothStatesTogether) {
  const std::pair<const char*, const char*> schemes[] = {{"gauss-newton", "exact"},
                                                         {"l-bfgs", "exact"},
                                                         {"steepest-descent", "exact"},
                                                         {"accumulated", "exact"},
                                                         {"accumulated", "transformed"}};
  for (const auto& [scheme, force] : schemes) {
    Scene scene;
    scene.unload(1.4 * true_shear_modulus);
    const double before = scene.error();
    const SimilaritySetup setup(scene.similarity_parameters, MPI_COMM_WORLD);
    const auto registration = configured<ImageForceRegistration>(
        {{"Scheme", scheme}, {"Force", force}, {"Levels", "4, 2"}});
    std::vector<double> values;
    const auto result =
        registration->run(scene.pair, setup, scene.surroundings, scene.material, Log(),
                          [&](const SimilarityRecord& record) { values.push_back(record.value); });
    ASSERT_GT(result.n_updates, 2u);
    EXPECT_TRUE(result.converged);
    EXPECT_LT(values.back(), 0.1 * values.front()) << scheme << ", " << force;
    EXPECT_LT(scene.error(), 0.35 * before) << scheme << ", " << force;
  }
}

} // namespace
} // namespace prosup::tests
