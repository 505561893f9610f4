#include "prosup/phantom/state_images.h"

#include <gtest/gtest.h>

#include <cmath>

#include "small_phantom.h"

namespace prosup::tests {
namespace {

using namespace prosup::phantom;
using dealii::Tensor;

constexpr unsigned seed = 5;

class Images : public ::testing::Test {
protected:
  image::ScalarImage image(Modality modality, const ImageErrors& errors,
                           const Tensor<1, 3>& shift = {}, unsigned state = 0) const {
    const auto points = material_points(brick_grid(), moved_brick(shift));
    return StateImages(anatomy_, points, seed, state)
        .image(Texture(anatomy_, seed), modality, errors);
  }

  const Anatomy anatomy_{small_geometry(), 0.3, seed};
};

/// Part of the voxels of the second image in which they differ.
template <class Image>
double different(const Image& a, const Image& b) {
  std::size_t n = 0;
  for (std::size_t v = 0; v < a.values.size(); ++v)
    n += a.values[v] != b.values[v];
  return double(n) / double(a.values.size());
}

TEST_F(Images, ShowTheTissueWhereItHasMovedTo) {
  const Tensor<1, 3> shift({2., -3., 1.}); // whole voxels
  const auto before = image(Modality::mr, {}), after = image(Modality::mr, {}, shift);
  for (unsigned k = 6; k < 20; ++k)
    for (unsigned j = 12; j < 24; ++j)
      for (unsigned i = 6; i < 20; ++i)
        EXPECT_NEAR(after(i + 2, j - 3, k + 1), before(i, j, k), 0.05); // floats, in a mesh
}

TEST_F(Images, AreThoseOfTheirSeed) {
  const ImageErrors errors{3., 0.2};
  const auto first = image(Modality::mr, errors);
  EXPECT_EQ(first.values, image(Modality::mr, errors).values);
  EXPECT_GT(different(first, image(Modality::mr, errors, {}, 1)), 0.9); // another state
}

TEST_F(Images, HaveTheNoiseAskedFor) {
  for (const Modality modality : {Modality::mr, Modality::ct}) {
    const auto clean = image(modality, {}), noisy = image(modality, {4., 0.});
    double squares = 0.;
    std::size_t n = 0;
    for (std::size_t v = 0; v < clean.values.size(); ++v)
      if (modality == Modality::ct || clean.values[v] > 60.f) { // Gaussian only far above noise
        squares += std::pow(noisy.values[v] - clean.values[v], 2);
        ++n;
      }
    EXPECT_NEAR(std::sqrt(squares / double(n)), 4., 0.1);
  }
}

TEST_F(Images, HaveTheIntensitiesOfTheirModality) {
  const auto points = material_points(brick_grid(), moved_brick({}));
  const auto labels = StateImages(anatomy_, points, seed, 0).labels();
  for (const Modality modality : {Modality::mr, Modality::ct}) {
    const auto picture = image(modality, {});
    double sum[4] = {};
    unsigned n[4] = {};
    for (std::size_t v = 0; v < labels.values.size(); ++v) {
      sum[labels.values[v]] += picture.values[v];
      ++n[labels.values[v]];
      EXPECT_GE(picture.values[v], modality == Modality::mr ? 0.f : -1000.f);
      EXPECT_LE(picture.values[v], modality == Modality::mr ? 300.f : 450.f);
    }
    ASSERT_GT(n[gland], 100u);
    const double contrast = sum[fat] / n[fat] - sum[gland] / n[gland];
    EXPECT_GT(modality == Modality::mr ? contrast : -contrast,
              60.); // fat: bright in MR, dark in CT
  }
}

TEST_F(Images, JitterOfLabelsHasItsSize) {
  const auto points = material_points(brick_grid(), moved_brick({}));
  const StateImages images(anatomy_, points, seed, 0);
  const auto exact = images.labels();
  EXPECT_EQ(images.jittered_labels(0.).values, exact.values);
  const double small = different(exact, images.jittered_labels(0.5)),
               large = different(exact, images.jittered_labels(2.));
  EXPECT_GT(small, 0.);
  EXPECT_GT(large, 2. * small);
  EXPECT_LT(large, 0.5);
}

TEST(Anatomy, HasItsPartOfGland) {
  const Geometry geometry = small_geometry();
  for (const double part : {0., 0.2, 0.5}) {
    const Anatomy anatomy(geometry, part, seed);
    unsigned n_gland = 0, n_tissue = 0;
    for (double x = -39.2; x < 40.; x += 1.6)
      for (double z = -39.2; z < 40.; z += 1.6)
        for (double y = -49.; y < 15.; y += 1.6) {
          const Label label = anatomy.label({x, y, z});
          n_tissue += label == fat || label == gland;
          n_gland += label == gland;
        }
    EXPECT_NEAR(double(n_gland) / n_tissue, part, 0.02);
  }
}

} // namespace
} // namespace prosup::tests
