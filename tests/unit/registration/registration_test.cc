#include <deal.II/base/mpi.h>
#include <gtest/gtest.h>

#include <cmath>

#include "loaded_box.h"
#include "prosup/core/error.h"
#include "prosup/mesh/scan_conversion.h"
#include "prosup/mesh/tet_mesh.h"
#include "prosup/registration/breast_pair.h"
#include "prosup/registration/comparison.h"
#include "prosup/registration/element_breast.h"
#include "prosup/registration/image_force_registration.h"
#include "prosup/registration/material_update.h"
#include "prosup/similarity/similarity_parameters.h"

namespace prosup::tests {
namespace {

using namespace dealii;
using namespace prosup::registration;
using mechanics::node_value;

constexpr double true_shear_modulus = 300.; // Pa
constexpr double true_poisson_ratio = 0.4;
const std::vector<unsigned> n_cells{5, 4, 5};
const Point<3> size(45., 32., 45.);
const PerPosition<Tensor<1, 3>> gravity{Tensor<1, 3>({0., -1., 0.}), Tensor<1, 3>({0., 1., 0.})};

float texture(const Point<3>& X) {
  return float(0.5 + 0.25 * std::sin(0.25 * X[0]) * std::cos(0.3 * X[1]) +
               0.25 * std::cos(0.22 * X[2] + 0.1 * X[1]));
}

/// The block ends there within its images, while make_box() gives the face the id of cut planes,
/// beyond which an image knows nothing.
void make_lower_end_skin(Distributed& mesh) {
  const auto cut_plane = mesh::boundary_id_of(mesh::BoundaryPart::cut_plane);
  for (const auto& cell : mesh.active_cell_iterators())
    for (const unsigned f : cell->face_indices())
      if (cell->face(f)->at_boundary() && cell->face(f)->boundary_id() == cut_plane)
        cell->face(f)->set_boundary_id(6);
}

/// The same textured block hanging and standing on its upper face, as images, with one breast of
/// each on the ranks of a split.
struct Scene {
  HangingBoxParameters parameters;
  Labels labels;
  mechanics::TissueMaterial material{labels};
  similarity::SimilarityParameters similarity_parameters;
  RankSplit ranks{MPI_COMM_WORLD};
  PerPosition<image::ScalarImage> images;
  similarity::Scene surroundings;
  std::unique_ptr<BreastPair> pair;

  /// The supine block hangs tilted, which is not told to the breast.
  explicit Scene(const Tilt& tilt = {}) {
    parameters.residual_tolerance = 1e-3;
    parameters.position_tolerance = 1e-2;
    const std::vector<mechanics::LameParameters> truth{
        mechanics::lame_parameters(true_shear_modulus, true_poisson_ratio)};
    PerPosition<std::unique_ptr<LoadedBox>> loaded;
    for (const Position position : both_positions) {
      loaded[position] = std::make_unique<LoadedBox>(
          n_cells, size, truth, parameters,
          position == Position::supine ? tilted(gravity.supine, tilt) : gravity.prone);
      images[position] = image_of(*loaded[position]);
      surroundings.labels[position] = image::LabelImage(grid(), 0);
    }
    pair = std::make_unique<BreastPair>(
        ranks, MechanicalProperties{material.initial()}, [&](Position position, MPI_Comm group) {
          const auto mesh = make_box(group, n_cells, size, *loaded[position]);
          make_lower_end_skin(*mesh);
          ElementBreast::Parts parts;
          parts.body = std::make_unique<mechanics::Body>(*mesh);
          parts.supports =
              std::make_unique<mechanics::Supports>(*parts.body, mechanics::BoundaryIds{3});
          parts.unloading = std::make_unique<unloading::Unloading>(parameters, *parts.supports,
                                                                   gravity[position]);
          if (tilt.left != 0. || tilt.superior != 0.)
            parts.gravity = gravity[position];
          return std::make_unique<ElementBreast>(position, std::move(parts), material);
        });
  }

  ComparedImages compared() const {
    return {images, surroundings, similarity_parameters.make_metric()};
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

  void unload(double shear_modulus, double poisson_ratio = true_poisson_ratio) {
    pair->set_properties({{shear_modulus, poisson_ratio, 1.}, 0.});
    const auto results = pair->unload();
    EXPECT_TRUE(results.prone.converged && results.supine.converged);
  }

  /// Mean distance between the unloaded positions and the true block, mm.
  double error() {
    double sum = 0.;
    unsigned n = 0;
    pair->for_each([&](Position, Breast& breast) {
      const auto mesh = make_box(ranks.group(), n_cells, size);
      const mechanics::Body block(*mesh); // the same topology has the same node numbers
      for (unsigned node = 0; node < block.n_owned_nodes(); ++node, ++n)
        sum += (node_value(breast.elements()->unloading().unloaded(), node) -
                node_value(block.vertex_positions(), node))
                   .norm();
    });
    return Utilities::MPI::sum(sum, MPI_COMM_WORLD) / Utilities::MPI::sum(n, MPI_COMM_WORLD);
  }
};

TEST(RankSplit, SharesTheRanks) {
  const RankSplit ranks(MPI_COMM_WORLD);
  const unsigned n = Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
  for (const Position position : both_positions)
    EXPECT_EQ(Utilities::MPI::sum(ranks.holds(position) ? 1u : 0u, MPI_COMM_WORLD),
              n == 1 ? 1u : (position == Position::prone ? (n + 1) / 2 : n / 2));
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) ==
      static_cast<unsigned>(ranks.first_rank(Position::supine))) {
    EXPECT_TRUE(ranks.holds(Position::supine));
  }
}

TEST(BreastPair, AFailureOfOneBreastIsTheFailureOfAll) {
  Scene scene;
  EXPECT_THROW(scene.pair->for_each([](Position position, Breast&) {
    if (position == Position::supine)
      throw Error("only supine");
  }),
               Error);
  EXPECT_THROW(
      BreastPair(scene.ranks, {},
                 [](Position, MPI_Comm) -> std::unique_ptr<Breast> { throw Error("no breast"); }),
      Error);
}

TEST(BreastPair, ReturnsToTheStateThatWasKept) {
  Scene scene;
  scene.unload(true_shear_modulus);
  const double error = scene.error();
  EXPECT_LT(error, 0.1);
  scene.pair->save();
  scene.unload(2. * true_shear_modulus);
  EXPECT_GT(scene.error(), 5. * error);
  scene.pair->restore();
  EXPECT_NEAR(scene.error(), error, 1e-9);
}

TEST(Comparison, ValueResidualsAndForcesBelongTogether) {
  Scene scene;
  scene.unload(1.4 * true_shear_modulus);
  const Comparison comparison(*scene.pair, scene.compared(), Compared::images, 2.);
  const double before = comparison.set_image_forces(similarity::Variable::displacement);
  EXPECT_DOUBLE_EQ(before, comparison.value());
  double squares = 0.;
  for (const float residual : comparison.residuals())
    squares += residual * residual;
  EXPECT_NEAR(0.5 * squares, before, 1e-4 * before);
  // Forces that act for a while bring the images together.
  scene.pair->for_each([](Position, Breast& breast) { breast.add_image_forces(30., 0., 5.); });
  scene.pair->advance(10.);
  EXPECT_LT(comparison.value(), 0.95 * before);
}

TEST(Comparison, OfTissuesIgnoresTheImages) {
  Scene scene;
  for (image::LabelImage* labels :
       {&scene.surroundings.labels.prone, &scene.surroundings.labels.supine})
    std::fill(labels->values.begin(), labels->values.end(), 2);
  scene.unload(true_shear_modulus);
  const Comparison comparison(*scene.pair, scene.compared(), Compared::tissues, 4.);
  EXPECT_EQ(comparison.name(), "ssd of tissues");
  // Fat everywhere in the bodies: what differs is the voxels that only one of them holds.
  const Comparison images(*scene.pair, scene.compared(), Compared::images, 4.);
  EXPECT_NE(comparison.value(), images.value());
  for (const Position position : both_positions)
    if (scene.ranks.holds(position)) {
      EXPECT_EQ(comparison.images()[position].values.front(), 0.5f);
    }
}

template <typename Stage>
std::unique_ptr<Stage> configured(const std::vector<std::array<const char*, 2>>& entries) {
  auto stage = std::make_unique<Stage>();
  ParameterHandler prm;
  ParameterAcceptor::declare_all_parameters(prm);
  for (const auto& [entry, value] : entries) {
    std::vector<std::string> path = Utilities::split_string_list(entry, '/');
    path.insert(path.begin(), stage->get_section_name());
    const std::string name = path.back();
    path.pop_back();
    for (const std::string& section : path)
      prm.enter_subsection(section);
    prm.set(name, std::string(value));
    for (std::size_t i = 0; i < path.size(); ++i)
      prm.leave_subsection();
  }
  ParameterAcceptor::parse_all_parameters(prm);
  return stage;
}

TEST(MaterialUpdate, StepwiseFindsTheShearModulusFromEitherSide) {
  Scene scene;
  const auto update = configured<MaterialUpdate>({{"Method", "stepwise"}, {"Levels", "2"}});
  for (const double factor : {1.1 * 1.1 * 1.1, 1. / (1.1 * 1.1)}) {
    scene.unload(factor * true_shear_modulus);
    const double before = scene.error();
    const auto result = update->run(*scene.pair, scene.compared(), Log());
    EXPECT_NEAR(scene.pair->properties().tissue.shear_modulus, true_shear_modulus,
                0.051 * true_shear_modulus);
    EXPECT_TRUE(result.converged);
    EXPECT_LT(scene.error(), 0.2 * before);
  }
}

TEST(MaterialUpdate, SearchFindsBothElasticConstants) {
  Scene scene;
  const auto update = configured<MaterialUpdate>({{"Levels", "4, 2"}});
  for (const double factor : {1.7, 0.75}) {
    scene.unload(factor * true_shear_modulus, 0.34);
    const double before = scene.error();
    const auto result = update->run(*scene.pair, scene.compared(), Log());
    const mechanics::TissueStiffness& found = scene.pair->properties().tissue;
    EXPECT_NEAR(found.shear_modulus, true_shear_modulus, 0.03 * true_shear_modulus);
    EXPECT_NEAR(found.poisson_ratio, true_poisson_ratio, 0.015);
    EXPECT_EQ(found.gland_ratio, 1.); // there is none
    EXPECT_TRUE(result.converged);
    EXPECT_LT(result.n_trials, 40u);
    EXPECT_LT(scene.error(), 0.1 * before);
  }
}

TEST(MaterialUpdate, SearchFindsTheTiltOfSupineGravity) {
  const double degree = numbers::PI / 180.;
  Scene scene({7. * degree, -4. * degree});
  const auto update = configured<MaterialUpdate>({{"Levels", "4, 2"}});
  scene.unload(1.2 * true_shear_modulus);
  const double before = scene.error();
  update->run(*scene.pair, scene.compared(), Log());
  const auto [left, superior] = scene.pair->properties().tilt.degrees();
  EXPECT_NEAR(left, 7., 0.7);
  EXPECT_NEAR(superior, -4., 0.7);
  EXPECT_LT(scene.error(), 0.15 * before);
}

TEST(MaterialUpdate, PriorDecidesWhatTheImagesDoNot) {
  const auto found = [](const char* correlation_length) {
    Scene scene;
    scene.unload(2. * true_shear_modulus);
    configured<MaterialUpdate>({{"Levels", "4"}, {"Correlation length", correlation_length}})
        ->run(*scene.pair, scene.compared(), Log());
    return scene.pair->properties().tissue.poisson_ratio;
  };
  // With one measurement for both constants that of the prior, 0.47, draws; with many it does not.
  EXPECT_NEAR(found("0"), 0.4, 0.02);
  EXPECT_NEAR(found("5"), 0.4, 0.02);
  EXPECT_GT(found("1000"), 0.43);
}

TEST(Tilt, TurnsGravityByItsAngles) {
  const double degree = numbers::PI / 180.;
  for (const Position position : both_positions) {
    const Tensor<1, 3> left = tilted(2. * gravity[position], {10. * degree, 0.}),
                       up = tilted(gravity[position], {0., -5. * degree});
    EXPECT_NEAR(left.norm(), 1., 1e-12);
    EXPECT_NEAR(left * gravity[position], std::cos(10. * degree), 1e-12);
    EXPECT_NEAR(left[0], std::sin(10. * degree), 1e-12);
    EXPECT_NEAR(up[2], -std::sin(5. * degree), 1e-12);
  }
  const Tensor<1, 3> on_the_side = tilted(Tensor<1, 3>({1., 0., 0.}), {10. * degree, 0.});
  EXPECT_NEAR(on_the_side[0], std::cos(10. * degree), 1e-12);
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
    const auto registration = configured<ImageForceRegistration>(
        {{"Scheme", scheme}, {"Accumulated/Force gradient", force}, {"Levels", "4, 2"}});
    std::vector<double> values;
    const auto result =
        registration->run(*scene.pair, scene.compared(), Log(),
                          [&](const SimilarityRecord& record) { values.push_back(record.value); });
    ASSERT_GT(result.n_updates, 2u);
    EXPECT_TRUE(result.converged);
    EXPECT_LT(values.back(), 0.1 * values.front()) << scheme << ", " << force;
    EXPECT_LT(scene.error(), 0.35 * before) << scheme << ", " << force;
  }
}

} // namespace
} // namespace prosup::tests
