#include "prosup/registration/pre_alignment.h"

#include <gtest/gtest.h>

#include "expect_error.h"
#include "prosup/image/image_io.h"

namespace prosup::tests {
namespace {

using dealii::Point;
using dealii::Tensor;
using image::RigidTransform;
using registration::Alignment;
using registration::PreAlignment;

/// The sample, whose chest is the same in both images; its surface is a cylinder.
struct Sample {
  const std::string folder = PROSUP_TEST_DATA "/small/";
  const image::ScalarImage prone = image::read_image(folder + "prone.nii.gz");
  const image::ScalarImage supine = image::read_image(folder + "supine.nrrd");
  const image::LabelImage prone_labels = image::read_labels(folder + "prone_labels.nii.gz");
  const image::LabelImage supine_labels = image::read_labels(folder + "supine_labels.mha");

  static const Sample& get() {
    static const Sample sample;
    return sample;
  }

  /// What is found if the supine patient lies elsewhere.
  Alignment align(const PreAlignment& method, const RigidTransform& elsewhere) const {
    return *align_if_needed(method, elsewhere);
  }
  std::optional<Alignment> align_if_needed(const PreAlignment& method,
                                           const RigidTransform& elsewhere) const {
    similarity::Scene scene;
    scene.labels = {prone_labels, supine_labels};
    image::ScalarImage moved = supine;
    moved.grid = elsewhere(moved.grid);
    scene.labels.supine.grid = moved.grid;
    return method.run(prone, moved, scene);
  }
};

void set_parameters(PreAlignment&, const std::string& method, const std::string& freedom) {
  dealii::ParameterHandler prm;
  dealii::ParameterAcceptor::declare_all_parameters(prm);
  prm.enter_subsection("Pre-alignment");
  prm.set("Method", method);
  prm.set("Degrees of freedom", freedom);
  prm.leave_subsection();
  dealii::ParameterAcceptor::parse_all_parameters(prm);
}

/// Largest distance (mm) of the corners of a box of 100 mm from where they were.
double largest_error(const RigidTransform& found, const RigidTransform& elsewhere) {
  double largest = 0.;
  for (unsigned corner = 0; corner < 8; ++corner) {
    Point<3> x = found.centre;
    for (unsigned d = 0; d < 3; ++d)
      x[d] += (corner >> d) & 1u ? 50. : -50.;
    largest = std::max(largest, found(elsewhere(x)).distance(x));
  }
  return largest;
}

// 0.3 mm is a tenth of a voxel.
TEST(PreAlignment, FindsAnOffsetAlongTheSurfaceAndAcross) {
  PreAlignment method;
  set_parameters(method, "chest intensities", "translation");
  RigidTransform elsewhere;
  elsewhere.translation = Tensor<1, 3>({7., -8., 10.});
  const Alignment found = Sample::get().align(method, elsewhere);
  EXPECT_LT(largest_error(found.transform, elsewhere), 0.3);
  EXPECT_GT(found.surface.distance_before, 5.);
  EXPECT_LT(found.surface.distance_after, 0.3);
  ASSERT_EQ(found.surface.open.size(), 1u); // the axis of the cylinder
  EXPECT_NEAR(std::abs(found.surface.open[0].translation[2]), 1., 0.01);
  EXPECT_GT(found.intensities->information_after, found.intensities->information_before);
}

// What a chest that is a cylinder shows of a rotation: that about an axis across it.
TEST(PreAlignment, FindsARotation) {
  PreAlignment method;
  set_parameters(method, "chest intensities", "rigid");
  RigidTransform elsewhere;
  elsewhere.rotation = image::rotation_about(Tensor<1, 3>({0.05, 0., 0.}));
  elsewhere.translation = Tensor<1, 3>({-5., 4., 3.});
  const Alignment found = Sample::get().align(method, elsewhere);
  EXPECT_LT(largest_error(found.transform, elsewhere), 0.5);
}

TEST(PreAlignment, SurfacesAloneLeaveTheAxisAsItIs) {
  PreAlignment method;
  set_parameters(method, "chest surface", "translation");
  RigidTransform elsewhere;
  elsewhere.translation = Tensor<1, 3>({6., 5., 10.});
  const Alignment found = Sample::get().align(method, elsewhere);
  EXPECT_NEAR(found.transform.translation[0], -6., 0.1);
  EXPECT_NEAR(found.transform.translation[1], -5., 0.1);
  EXPECT_NEAR(found.transform.translation[2], 0., 0.1);
  EXPECT_FALSE(found.intensities.has_value());
}

// Less than 1.5 mm may be the masks and the ribs, and what lies far off is for the check of the
// scene.
TEST(PreAlignment, AutomaticMovesOnlyWhatFitsAfterASmallMotion) {
  PreAlignment method;
  set_parameters(method, "automatic", "rigid");
  const auto found = [&](double right, double back, double turn = 0.) {
    RigidTransform elsewhere;
    elsewhere.rotation = image::rotation_about(Tensor<1, 3>({0., 0., turn}));
    elsewhere.translation = Tensor<1, 3>({right, back, 0.});
    return Sample::get().align_if_needed(method, elsewhere);
  };
  EXPECT_FALSE(found(0., 0.4)); // voxels of 2.5 mm
  EXPECT_FALSE(found(0., 20.));
  EXPECT_FALSE(found(500., 0.));
  EXPECT_FALSE(found(0., 0., dealii::numbers::PI));
  const auto moved = found(0., 8.);
  ASSERT_TRUE(moved);
  EXPECT_NEAR(moved->transform.translation[1], -8., 0.3);
}

TEST(PreAlignment, RefusesChestsWithNothingInCommon) {
  PreAlignment method;
  set_parameters(method, "chest surface", "translation");
  RigidTransform elsewhere;
  elsewhere.translation[0] = 500.;
  expect_error([&] { Sample::get().align(method, elsewhere); },
               {"no surface in common", "Pre-alignment/Method"});
}

} // namespace
} // namespace prosup::tests
