#include "prosup/registration/agreement.h"

#include <gtest/gtest.h>

namespace prosup::tests {
namespace {

using namespace prosup::registration;
using dealii::Point;
using dealii::Tensor;
using image::LabelImage;
using image::VoxelGrid;

constexpr unsigned chest = 1, fat = 2, gland = 3;
const Point<3> corner(0., -10., 0.), far_corner(60., 50., 60.); // of the field of view

VoxelGrid grid(const Tensor<1, 3>& shift = {}) {
  VoxelGrid grid = image::grid_around(corner, far_corner, 1., 0.);
  grid.origin += shift;
  return grid;
}

/// Chest at high y, above `wall`, and tissue below.
LabelImage scene_labels(const VoxelGrid& grid, double wall) {
  LabelImage labels(grid);
  std::size_t v = 0;
  for (std::size_t k = 0; k < grid.size[2]; ++k)
    for (std::size_t j = 0; j < grid.size[1]; ++j)
      for (std::size_t i = 0; i < grid.size[0]; ++i, ++v)
        labels.values[v] = grid.physical(double(i), double(j), double(k))[1] > wall ? chest : fat;
  return labels;
}

similarity::Scene scene(const LabelImage& prone, const LabelImage& supine) {
  similarity::Scene scene;
  scene.labels = {prone, supine};
  return scene;
}

TEST(ChestMisfit, IsTheDistanceOfTheWalls) {
  const ChestMisfit same =
      measure_chest_misfit(scene(scene_labels(grid(), 30.), scene_labels(grid(), 30.)));
  EXPECT_NEAR(same.shared, 1., 0.01);
  EXPECT_NEAR(same.median, 0., 0.01);
  const ChestMisfit apart =
      measure_chest_misfit(scene(scene_labels(grid(), 30.), scene_labels(grid(), 38.)));
  EXPECT_NEAR(apart.median, 8., 1.);
  EXPECT_NEAR(apart.p95, 8., 1.);
}

TEST(ChestMisfit, KnowsWhatOnlyOneImageShows) {
  const Tensor<1, 3> half({30., 0., 0.}), far({400., 0., 0.});
  EXPECT_NEAR(
      measure_chest_misfit(scene(scene_labels(grid(), 30.), scene_labels(grid(half), 30.))).shared,
      0.5, 0.1);
  EXPECT_EQ(
      measure_chest_misfit(scene(scene_labels(grid(), 30.), scene_labels(grid(far), 30.))).shared,
      0.);
  EXPECT_EQ(measure_chest_misfit(scene(scene_labels(grid(), 30.), LabelImage(grid(), fat))).shared,
            0.);
}

/// A block of tissue below the wall that does not move, so that it is its own unloaded shape.
class Block : public Breast {
public:
  Block(Point<3> low, Point<3> high) : low_(low), high_(high) {}

  bool has_gland() const override { return true; }
  void set_properties(const MechanicalProperties&) override {}
  settling::SettlingResult unload(const settling::Effort&) override { return {}; }
  settling::SettlingResult load() override { return {}; }
  settling::SettlingResult advance(double) override { return {}; }
  void save() override {}
  void restore() override {}
  similarity::Box unloaded_box() const override {
    similarity::Box box;
    box.include(low_);
    box.include(high_);
    return box;
  }
  bool samples_surroundings() const override { return false; }
  const similarity::Samples& sample(const similarity::SimilarityDomain& domain,
                                    const image::ScalarImage& image) override {
    samples_ = {};
    std::uint32_t v = 0;
    for (std::size_t k = 0; k < domain.grid.size[2]; ++k)
      for (std::size_t j = 0; j < domain.grid.size[1]; ++j)
        for (std::size_t i = 0; i < domain.grid.size[0]; ++i, ++v) {
          const Point<3> x = domain.grid.physical(double(i), double(j), double(k));
          bool inside = true;
          for (unsigned d = 0; d < 3; ++d)
            inside = inside && x[d] > low_[d] && x[d] < high_[d];
          if (!inside)
            continue;
          const Point<3> at = image.grid.continuous_index(x);
          samples_.add(
              v,
              image(std::size_t(at[0] + 0.5), std::size_t(at[1] + 0.5), std::size_t(at[2] + 0.5)),
              similarity::cover::tissue, {});
        }
    return samples_;
  }
  void set_image_forces(const std::vector<float>&, similarity::Variable) override {}
  void add_image_forces(double, double, double) override {}
  void forget_momentum() override {}
  mesh::UnloadedMesh mesh() const override { return {}; }

private:
  const Point<3> low_, high_;
  similarity::Samples samples_;
};

/// Air around the tissue, and gland in a block in its middle.
struct Pair {
  RankSplit ranks{MPI_COMM_WORLD};
  similarity::Scene scene;
  PerPosition<image::ScalarImage> images;
  std::unique_ptr<BreastPair> pair;

  Pair(double supine_top, double gland_shift) {
    for (const Position position : both_positions) {
      const double shift = position == Position::prone ? 0. : gland_shift;
      LabelImage labels(grid());
      images[position] = image::ScalarImage(grid());
      for (std::size_t v = 0; v < labels.values.size(); ++v) {
        const std::size_t i = v % labels.grid.size[0],
                          j = v / labels.grid.size[0] % labels.grid.size[1];
        const Point<3> x = labels.grid.physical(double(i), double(j), 0.);
        const bool in_gland = std::abs(x[0] - 30. - shift) < 9.;
        labels.values[v] = x[1] > 40. ? chest : in_gland ? gland : fat;
        images[position].values[v] = in_gland ? 1.f : 0.f;
      }
      // Air all around, so that the body touches no face.
      for (std::size_t v = 0; v < labels.values.size(); ++v) {
        const std::size_t i = v % labels.grid.size[0],
                          j = v / labels.grid.size[0] % labels.grid.size[1],
                          k = v / labels.grid.size[0] / labels.grid.size[1];
        if (i == 0 || j == 0 || k == 0 || i + 1 == labels.grid.size[0] ||
            j + 1 == labels.grid.size[1] || k + 1 == labels.grid.size[2])
          labels.values[v] = 0;
      }
      scene.labels[position] = labels;
    }
    pair = std::make_unique<BreastPair>(
        ranks, MechanicalProperties{}, [&](Position position, MPI_Comm) {
          return std::make_unique<Block>(
              Point<3>(8., 2., 8.),
              Point<3>(50., position == Position::prone ? 38. : supine_top, 50.));
        });
  }

  Agreement measure() const { return measure_agreement(*pair, {images, scene, nullptr}, true); }
};

TEST(Agreement, IsFullOfTwoEqualBreasts) {
  const Agreement found = Pair(38., 0.).measure();
  EXPECT_DOUBLE_EQ(found.compared_share, 1.);
  EXPECT_DOUBLE_EQ(found.volume_ratio, 1.);
  EXPECT_DOUBLE_EQ(found.breast_dice, 1.);
  EXPECT_DOUBLE_EQ(found.gland_dice, 1.);
  EXPECT_DOUBLE_EQ(found.skin_distance, 0.);
  EXPECT_DOUBLE_EQ(found.outside_share, 0.);
  EXPECT_NEAR(found.intensities->correlation, 1., 1e-6);
}

TEST(Agreement, SeesOutlinesThatDiffer) {
  const Agreement found = Pair(26., 0.).measure(); // 24 instead of 36 mm
  EXPECT_NEAR(found.volume_ratio, 1.5, 0.1);
  EXPECT_NEAR(found.breast_dice, 0.8, 0.03);
  EXPECT_GT(found.skin_distance, 1.);
  EXPECT_NEAR(found.skin_p95, 12., 2.);
  EXPECT_NEAR(found.outside_share, 7. / 36., 0.06);
}

TEST(Agreement, SeesGlandThatIsElsewhere) {
  const Agreement found = Pair(38., 9.).measure();
  EXPECT_DOUBLE_EQ(found.breast_dice, 1.);
  EXPECT_NEAR(found.gland_dice, 0.5, 0.15); // 9 of 18 mm, on voxels of 3 mm
  EXPECT_LT(found.intensities->correlation, 0.5);
}

} // namespace
} // namespace prosup::tests
