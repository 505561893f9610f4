#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "expect_error.h"
#include "preparation_of.h"
#include "prosup/image/filters.h"
#include "prosup/prepare/bias_field.h"
#include "prosup/prepare/body_outline.h"
#include "prosup/prepare/breast_region.h"
#include "prosup/prepare/chest_wall.h"
#include "prosup/prepare/tissues.h"
#include "synthetic_chest.h"

namespace prosup::tests {
namespace {

using prepare::Contrast;

bool is_body(unsigned label) {
  return label != 0;
}
bool is_breast(unsigned label) {
  return label >= 2;
}
bool is_gland(unsigned label) {
  return label == 3;
}

// Several tests share the scans.

struct Kind {
  const char* name;
  SyntheticContrast contrast;
  bool is_ct, fat_is_bright;
  SyntheticChest chest{contrast};
};

const std::vector<Kind>& kinds() {
  static const std::vector<Kind> all{{"bright fat", {}, false, true},
                                     {"suppressed fat", suppressed_fat(), false, false},
                                     {"CT", hounsfield(), true, false}};
  return all;
}

/// A chest with a strong bias and its outline.
struct Biased {
  SyntheticChest chest{{}, 0.6};
  prepare::Outline outline = prepare::find_outline(chest.image, false);
};

const Biased& biased() {
  static const Biased scan;
  return scan;
}

TEST(Outline, ContainsTheLungThatTheImageEndsIn) {
  const SyntheticChest& chest = kinds().front().chest;
  const prepare::Outline outline = prepare::find_outline(chest.image, false);
  for (const prepare::Outline* found : {&outline, &biased().outline}) {
    EXPECT_GT(dice(found->body, chest.labels, is_body), 0.985);
    EXPECT_NEAR(found->air, 4., 1.);
  }
}

// Ghosts of the moving heart, beside the body and from 5 mm in front of its skin on, are a quarter
// as bright as fat in the mean and half as bright in places.
TEST(Outline, LeavesOutGhostsBesideTheBody) {
  SyntheticChest chest(suppressed_fat());
  std::mt19937 generator(2);
  std::normal_distribution<double> part(0., 12.);
  for (std::size_t k = 0; k < 28; ++k)
    for (std::size_t j = 0; j < 61; ++j)
      for (std::size_t i = 0; i < 98; ++i) {
        const image::Point<3> p = chest.labels.grid.physical(double(i), double(j), double(k));
        if (p[1] > 40. && chest.labels(i, j, k) == 0)
          chest.image(i, j, k) = float(std::hypot(part(generator), part(generator)));
      }
  const prepare::Outline outline = prepare::find_outline(chest.image, false);
  EXPECT_GT(dice(outline.body, chest.labels, is_body), 0.985);
}

TEST(Outline, OfNothingIsRefused) {
  image::VoxelGrid grid;
  grid.size = {20, 20, 20};
  for (const float value : {0.f, 3.f})
    expect_error([&] { prepare::find_outline(image::ScalarImage(grid, value), false); },
                 {"outline", "air"});
}

/// Mean distance of a wall to the true one under the breasts, mm.
double distance_to_truth(const prepare::ChestWall& wall) {
  const prepare::TrunkAxis& axis = wall.surface.grid.axis;
  double sum = 0.;
  std::size_t n = 0;
  for (double z = -35.; z <= 35.; z += 5.)
    for (double angle = -0.6; angle <= 0.6; angle += 0.05) {
      const image::Point<3> p = axis.position(wall.surface(angle, z), angle, z);
      sum +=
          std::abs(std::hypot(p[0], p[1] - SyntheticChest::axis_y) - SyntheticChest::chest_radius);
      ++n;
    }
  return sum / double(n);
}

prepare::ChestWall wall_of(const SyntheticChest& chest, bool is_ct, bool fat_is_bright) {
  const prepare::Outline outline = prepare::find_outline(chest.image, is_ct);
  const prepare::TrunkAxis axis = prepare::find_trunk_axis(outline.body);
  EXPECT_NEAR(axis.x, 0., 5.); // mm, two voxels
  return prepare::find_chest_wall({chest.image, outline.body, outline.air, is_ct}, axis,
                                  fat_is_bright);
}

TEST(ChestWall, IsFoundWithinAMillimetre) {
  for (const Kind& kind : kinds()) {
    SCOPED_TRACE(kind.name);
    const prepare::ChestWall wall = wall_of(kind.chest, kind.is_ct, kind.fat_is_bright);
    EXPECT_LT(distance_to_truth(wall), 1.); // mm; voxels are 2.5 mm
    EXPECT_EQ(wall.bridged.area, 0.);
    EXPECT_EQ(wall.departure.area, 0.);
  }
}

// Two balls of gland of 44 mm, with the intensity of muscle, sunk into the chest by a third.
TEST(ChestWall, IsContinuedBehindGlandThatLiesOnIt) {
  SyntheticContrast contrast;
  contrast.gland = contrast.muscle;
  const prepare::ChestWall wall = wall_of(SyntheticChest(contrast, 0., 43.), false, true);
  EXPECT_LT(distance_to_truth(wall), 2.5); // mm; a third of it is hidden
  EXPECT_GT(wall.bridged.area, 10.);       // cm^2, of two discs of 14
  EXPECT_GT(wall.bridged.largest, 15.);    // mm
  EXPECT_NEAR(std::abs(wall.bridged.position[0]), SyntheticChest::breast_x, 20.);
  EXPECT_EQ(wall.departure.area, 0.);
}

// At the upper end of the scan, what lies 40 mm deep behind the front of the chest has the
// intensity of fat, and bright vessels follow: there is no edge but one deep in the chest.
TEST(ChestWall, StaysInFrontOfEdgesDeepInTheChest) {
  SyntheticChest chest(suppressed_fat());
  std::mt19937 generator(2);
  std::normal_distribution<double> noise(0., 4.);
  for (std::size_t k = 0; k < 28; ++k)
    for (std::size_t j = 0; j < 61; ++j)
      for (std::size_t i = 0; i < 98; ++i) {
        const image::Point<3> p = chest.labels.grid.physical(double(i), double(j), double(k));
        const double depth =
            SyntheticChest::chest_radius - std::hypot(p[0], p[1] - SyntheticChest::axis_y);
        if (std::abs(p[0]) < 30. && p[2] > 5. && depth > 0.)
          chest.image(i, j, k) = float((depth < 40. ? 60. : 150.) + noise(generator));
      }
  const prepare::ChestWall wall = wall_of(chest, false, false);
  for (double x = -10.; x <= 10.; x += 5.)
    EXPECT_NEAR(wall.surface(x / SyntheticChest::chest_radius, 30.), SyntheticChest::chest_radius,
                20.);
}

TEST(Tissues, LieMidwayAndKeepTheirFraction) {
  for (const Kind& kind : kinds()) {
    SCOPED_TRACE(kind.name);
    const SyntheticChest& chest = kind.chest;
    const image::LabelImage inner = chest.inner();
    double gland = 0.;
    for (const std::uint8_t label : chest.labels.values)
      gland += is_gland(label);
    const prepare::Tissues tissues =
        prepare::find_tissues({chest.image, inner, kind.is_ct, kind.fat_is_bright});
    double both = 0., fraction = 0.;
    for (std::size_t v = 0; v < inner.values.size(); ++v) {
      both += chest.labels.values[v] == 3 && tissues.gland.values[v] != 0;
      fraction += double(tissues.fraction.values[v]);
      EXPECT_GE(tissues.fraction.values[v], 0.f);
      EXPECT_LE(tissues.fraction.values[v], 1.f);
    }
    EXPECT_GT(both, 0.95 * gland);
    EXPECT_NEAR(fraction / gland, 1., 0.1);
    EXPECT_GT(tissues.separation(), 3.);
  }
}

// Two voxels of 19 mm^3 in the fat of a breast.
TEST(Tissues, LeaveOutWhatHangsTogetherWithNoGland) {
  SyntheticChest chest(suppressed_fat());
  const image::Point<3> place(SyntheticChest::breast_x, 40., 0.);
  const image::Point<3> index = chest.labels.grid.continuous_index(place);
  const auto at = [&](unsigned d) { return std::size_t(std::lround(index[d])); };
  for (const std::size_t k : {at(2), at(2) + 1}) {
    ASSERT_EQ(chest.labels(at(0), at(1), k), 2);
    chest.image(at(0), at(1), k) = float(suppressed_fat().gland);
  }
  const prepare::Tissues tissues =
      prepare::find_tissues({chest.image, chest.inner(), false, false});
  for (const std::size_t k : {at(2), at(2) + 1}) {
    EXPECT_EQ(tissues.gland(at(0), at(1), k), 0);
    EXPECT_EQ(tissues.fraction(at(0), at(1), k), 0.f);
  }
}

TEST(Tissues, OfNothingAreRefused) {
  const SyntheticChest& chest = kinds().front().chest;
  const image::LabelImage nothing(chest.labels.grid);
  expect_error([&] { prepare::find_tissues({chest.image, nothing, false, true}); }, {"inside"});
}

// What is left of the variation of fat over the breast.
TEST(Bias, IsRemoved) {
  const SyntheticChest& chest = biased().chest;
  const prepare::Outline& outline = biased().outline;
  const image::ScalarImage corrected =
      prepare::without_bias(chest.image, outline.body, outline.threshold);
  const image::LabelImage& labels = chest.labels;
  const auto variation = [&](const image::ScalarImage& image) {
    double n = 0., sum = 0., squares = 0.;
    for (std::size_t v = 0; v < image.values.size(); ++v)
      if (labels.values[v] == 2) {
        const double value = double(image.values[v]);
        n += 1.;
        sum += value;
        squares += value * value;
      }
    const double mean = sum / n;
    return std::sqrt(squares / n - mean * mean) / mean;
  };
  EXPECT_LT(variation(corrected), 0.7 * variation(chest.image));
}

TEST(Preparation, LabelsAWholeScan) {
  for (const Kind& kind : kinds()) {
    SCOPED_TRACE(kind.name);
    const SyntheticChest chest(kind.contrast, kind.is_ct ? 0. : 0.3);
    const prepare::PreparedScan scan = PreparationOf({}).run(chest.image);
    EXPECT_EQ(scan.contrast, kind.is_ct           ? Contrast::ct
                             : kind.fat_is_bright ? Contrast::t1
                                                  : Contrast::t1_fat_suppressed);
    ASSERT_EQ(scan.labels.values.size(), chest.labels.values.size());
    EXPECT_GT(dice(scan.labels, chest.labels, is_breast), 0.95);
    EXPECT_GT(dice(scan.labels, chest.labels, is_gland), 0.88);
    EXPECT_GT(scan.gland_volume, 60.); // ml, of two balls of 44.6
    EXPECT_LT(scan.confidence.weak_edge, 0.1);
    EXPECT_TRUE(scan.confidence.doubts.empty()) << scan.confidence.doubts.front();
  }
}

// The left half alone: to the right of it the profiles from the trunk end within the chest.
TEST(Preparation, LabelsAScanOfOneSide) {
  for (const Kind& kind : kinds()) {
    SCOPED_TRACE(kind.name);
    const image::VoxelGrid& grid = kind.chest.image.grid;
    const image::VoxelBox half{{grid.size[0] / 2, 0, 0}, grid.size};
    const prepare::PreparedScan scan =
        PreparationOf({}).run(image::part_of(kind.chest.image, half));
    const image::LabelImage truth = image::part_of(kind.chest.labels, half);
    EXPECT_EQ(prepare::fat_is_bright(scan.contrast), kind.fat_is_bright);
    EXPECT_GT(dice(scan.labels, truth, is_breast), 0.95);
    EXPECT_GT(dice(scan.labels, truth, is_gland), 0.88);
    EXPECT_TRUE(scan.confidence.doubts.empty()) << scan.confidence.doubts.front();
  }
}

TEST(Preparation, CutsOutOneBreast) {
  const SyntheticChest& chest = kinds().front().chest;
  const prepare::PreparedScan scan =
      PreparationOf(
          {"Preparation/Side=left", "Preparation/Contrast=t1", "Preparation/Bias correction=none"})
          .run(chest.image);
  EXPECT_LT(scan.labels.grid.size[0], chest.labels.grid.size[0]);
  EXPECT_TRUE(scan.labels.grid.coincides_with(scan.image.grid));
  EXPECT_TRUE(scan.gland.grid.coincides_with(scan.image.grid));
  double sum = 0., n = 0.;
  for (std::size_t i = 0; i < scan.labels.grid.size[0]; ++i)
    for (std::size_t j = 0; j < scan.labels.grid.size[1]; ++j)
      for (std::size_t k = 0; k < scan.labels.grid.size[2]; ++k)
        if (scan.labels(i, j, k) == 3) {
          sum += scan.labels.grid.physical(double(i), double(j), double(k))[0];
          n += 1.;
        }
  EXPECT_NEAR(sum / n, 60., 8.); // mm; a little of the other side is in the margin
}

TEST(Preparation, RefusesACTThatIsGivenAsMRAndTheReverse) {
  expect_error([&] { PreparationOf({"Preparation/Contrast=ct"}).run(kinds().front().chest.image); },
               {"'ct'", "-500", "Hounsfield"});
  for (const std::string contrast : {"t1", "t1fs", "t2"})
    expect_error(
        [&] {
          PreparationOf({"Preparation/Contrast=" + contrast}).run(kinds().back().chest.image);
        },
        {"'" + contrast + "'", "-500", "CT"});
}

// The middle of the body is that of the breast there.
TEST(Preparation, RefusesASideOfAScanOfOneSide) {
  const SyntheticChest& chest = kinds().front().chest;
  const image::VoxelBox half{{chest.image.grid.size[0] / 2, 0, 0}, chest.image.grid.size};
  for (const std::string side : {"left", "right"})
    expect_error(
        [&] {
          PreparationOf({"Preparation/Side=" + side, "Preparation/Bias correction=none"})
              .run(image::part_of(chest.image, half));
        },
        {"one breast only", "--side " + side});
}

TEST(BreastBox, IsOnTheSideThatIsWanted) {
  const SyntheticChest& chest = kinds().front().chest;
  image::LabelImage front(chest.labels.grid);
  for (std::size_t v = 0; v < front.values.size(); ++v)
    front.values[v] = is_breast(chest.labels.values[v]);
  prepare::TrunkSurface wall;
  wall.grid = prepare::trunk_grid({0., SyntheticChest::axis_y, 10.}, front.grid, 0.1, 10.);
  wall.radius.assign(wall.grid.n_rows * wall.grid.n_columns, SyntheticChest::chest_radius);
  const image::VoxelBox left = prepare::breast_box(front, wall, prepare::Side::left, 0.),
                        right = prepare::breast_box(front, wall, prepare::Side::right, 0.);
  EXPECT_GT(front.grid.physical(double(left.begin[0]), 0., 0.)[0], 0.);
  EXPECT_LT(front.grid.physical(double(right.end[0] - 1), 0., 0.)[0], 0.);
  wall.radius.assign(wall.radius.size(), 250.);
  expect_error([&] { prepare::breast_box(front, wall, prepare::Side::left, 0.); }, {"left"});
}

TEST(Preparation, RefusesABreastThatIsCutOff) {
  const SyntheticChest& chest = kinds().front().chest;
  const image::VoxelBox box{{0, 20, 0}, chest.image.grid.size};
  prepare::require_whole_front(chest.labels);
  expect_error([&] { prepare::require_whole_front(image::part_of(chest.labels, box)); },
               {"front border", "cm^2", "header"});
}

} // namespace
} // namespace prosup::tests
