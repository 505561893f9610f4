#include <gtest/gtest.h>

#include <cmath>

#include "expect_error.h"
#include "prosup/core/parameters.h"
#include "prosup/prepare/bias_field.h"
#include "prosup/prepare/body_outline.h"
#include "prosup/prepare/breast_region.h"
#include "prosup/prepare/chest_wall.h"
#include "prosup/prepare/preparation.h"
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

TEST(Outline, ContainsTheLungThatTheImageEndsIn) {
  for (const double bias : {0., 0.6}) {
    const SyntheticChest chest({}, bias);
    const prepare::Outline outline = prepare::find_outline(chest.image, false);
    EXPECT_GT(dice(outline.body, chest.labels, is_body), 0.985);
    EXPECT_NEAR(outline.air, 4., 1.);
  }
}

TEST(Outline, OfNothingIsRefused) {
  image::VoxelGrid grid;
  grid.size = {20, 20, 20};
  expect_error([&] { prepare::find_outline(image::ScalarImage(grid, 3.f), false); },
               {"outline", "air"});
}

// What is left of the variation of fat over the breast.
TEST(Bias, IsRemoved) {
  const SyntheticChest chest({}, 0.6);
  const prepare::Outline outline = prepare::find_outline(chest.image, false);
  const image::ScalarImage corrected =
      prepare::without_bias(chest.image, outline.body, outline.threshold);
  const auto variation = [&](const image::ScalarImage& image) {
    double n = 0., sum = 0., squares = 0.;
    for (std::size_t v = 0; v < image.values.size(); ++v)
      if (chest.labels.values[v] == 2) {
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

struct Kind {
  const char* name;
  SyntheticContrast contrast;
  bool is_ct, fat_is_bright;
};

const std::vector<Kind>& kinds() {
  static const std::vector<Kind> all{{"bright fat", {}, false, true},
                                     {"suppressed fat", suppressed_fat(), false, false},
                                     {"CT", hounsfield(), true, false}};
  return all;
}

TEST(ChestWall, IsFoundWithinAMillimetre) {
  for (const Kind& kind : kinds()) {
    SCOPED_TRACE(kind.name);
    const SyntheticChest chest(kind.contrast);
    const prepare::Outline outline = prepare::find_outline(chest.image, kind.is_ct);
    const prepare::TrunkAxis axis = prepare::find_trunk_axis(outline.body);
    EXPECT_NEAR(axis.x, 0., 5.); // mm, two voxels
    const prepare::ChestImage image{chest.image, outline.body, outline.air, kind.is_ct};
    const prepare::ChestWall wall = prepare::find_chest_wall(image, axis, kind.fat_is_bright);
    double sum = 0.;
    std::size_t n = 0;
    for (double z = -55.; z <= 55.; z += 5.)
      for (double angle = -0.6; angle <= 0.6; angle += 0.05) {
        const image::Point<3> p = axis.position(wall.surface(angle, z), angle, z);
        sum += std::abs(std::hypot(p[0], p[1] - SyntheticChest::axis_y) -
                        SyntheticChest::chest_radius);
        ++n;
      }
    EXPECT_LT(sum / double(n), 1.); // mm; voxels are 2.5 mm
    if (!kind.is_ct) {
      EXPECT_EQ(prepare::find_chest_wall(image, axis, std::nullopt).fat.is_bright,
                kind.fat_is_bright);
    }
  }
}

TEST(Tissues, LieMidwayAndKeepTheirFraction) {
  for (const Kind& kind : kinds()) {
    SCOPED_TRACE(kind.name);
    const SyntheticChest chest(kind.contrast);
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

TEST(Tissues, OfNothingAreRefused) {
  const SyntheticChest chest;
  const image::LabelImage nothing(chest.labels.grid);
  expect_error([&] { prepare::find_tissues({chest.image, nothing, false, true}); }, {"inside"});
}

class PreparationOf {
public:
  explicit PreparationOf(const std::vector<Override>& overrides) : preparation_(labels_) {
    read_parameters("", overrides);
  }
  prepare::PreparedScan run(const image::ScalarImage& scan) const {
    return preparation_.run(scan, Log());
  }

private:
  Labels labels_;
  prepare::Preparation preparation_;
};

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
  }
}

TEST(Preparation, CutsOutOneBreast) {
  const SyntheticChest chest;
  for (const bool left : {true, false}) {
    const prepare::PreparedScan scan =
        PreparationOf({std::string("Preparation/Side=") + (left ? "left" : "right")})
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
    EXPECT_NEAR(sum / n, left ? 60. : -60., 8.); // mm; a little of the other side is in the margin
  }
}

TEST(Preparation, RefusesABreastThatIsCutOff) {
  const SyntheticChest chest;
  const image::VoxelBox box{{0, 20, 0}, chest.image.grid.size};
  prepare::require_whole_front(chest.labels);
  expect_error([&] { prepare::require_whole_front(image::part_of(chest.labels, box)); },
               {"front border", "cm^2"});
}

} // namespace
} // namespace prosup::tests
