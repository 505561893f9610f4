#include "prosup/registration/verdict.h"

#include <gtest/gtest.h>

namespace prosup::tests {
namespace {

using namespace prosup::registration;

Agreement agreement(double breast_dice) {
  Agreement a;
  a.compared_share = 0.99;
  a.breast_dice = breast_dice;
  a.gland_dice = 0.9;
  a.intensities = {0.98, 0.6, 0.3};
  return a;
}

/// The figures of a right registration.
Quality right() {
  Quality quality;
  quality.converged = true;
  quality.properties = {{160., 0.46, 2.5}, 7.};
  quality.jacobian = {{0.7, 1.8}, {0.6, 1.5}};
  quality.unloaded_quality = {0.2, 0.2};
  quality.chest = {1., 0.2, 1.};
  quality.motion = {20., 15.};
  quality.unloaded = agreement(0.94);
  quality.material = agreement(0.985);
  quality.image_forces = agreement(0.992);
  return quality;
}

void expect(Grade grade, const std::string& words, const Quality& quality) {
  const Verdict verdict = judge(quality);
  EXPECT_STREQ(name_of(verdict.grade), name_of(grade)) << words;
  ASSERT_FALSE(verdict.reasons.empty()) << words;
  EXPECT_NE(verdict.reasons.front().find(words), std::string::npos) << verdict.reasons.front();
}

TEST(Verdict, IsGoodForARightRegistrationAndHasNoReasons) {
  const Verdict verdict = judge(right());
  EXPECT_STREQ(name_of(verdict.grade), "good");
  EXPECT_TRUE(verdict.reasons.empty()) << verdict.reasons.front();
}

TEST(Verdict, FailsWhatDidNotSettle) {
  Quality quality = right();
  quality.converged = false;
  expect(Grade::failed, "did not settle", quality);
}

TEST(Verdict, KeepsTheDoubtsOfTheCheckOfTheScene) {
  Quality quality = right();
  quality.scene_findings = {"Label 7 is not explained."};
  expect(Grade::doubtful, "Label 7", quality);
}

// Each of these figures alone is a doubt; five of them say that nothing fits.
TEST(Verdict, FailsWhereManyFiguresAreDoubtful) {
  Quality quality = right();
  quality.chest.median = 4.2;
  quality.image_forces->breast_dice = 0.92;
  quality.image_forces->gland_dice = 0.75;
  quality.material->breast_dice = 0.88;
  quality.scene_findings = {"Label 7 is not explained."}; // is no figure
  EXPECT_STREQ(name_of(judge(quality).grade), "doubtful");
  quality.image_forces->outside_share = 0.006;
  expect(Grade::failed, "5 figures are out of the usual", quality);
}

TEST(Verdict, NamesPropertiesAtTheirBounds) {
  Quality quality = right();
  quality.at_bound = {"gland ratio"};
  expect(Grade::doubtful, "gland ratio", quality);
  quality.at_bound = {"gland ratio", "Poisson ratio"};
  expect(Grade::failed, "gland ratio", quality);
}

TEST(Verdict, SeesMotionAgainstGravityAndNone) {
  Quality quality = right();
  quality.motion = {20., -15.};
  expect(Grade::failed, "15.0 mm against gravity", quality);
  quality.motion = {0.01, 0.};
  expect(Grade::failed, "0.01 mm from prone to supine", quality);
}

TEST(Verdict, SeesFlatAndSqueezedCells) {
  Quality quality = right();
  quality.jacobian.supine.max = 4.;
  expect(Grade::doubtful, "supine breast is 4 times", quality);
  quality = right();
  quality.jacobian.prone.min = -0.1;
  expect(Grade::failed, "prone breast is squeezed to -0.1", quality);
}

TEST(Verdict, SeesChestsThatDoNotMeet) {
  Quality quality = right();
  quality.chest.median = 5.;
  expect(Grade::doubtful, "5.0 mm apart", quality);
  quality.chest = {0., 0., 0.};
  expect(Grade::failed, "Only 0 % of the chest", quality);
}

TEST(Verdict, SeesWhatImageForcesHadToHide) {
  Quality quality = right();
  quality.material->breast_dice = 0.8;
  quality.unloaded->breast_dice = 0.8;
  expect(Grade::doubtful, "Before image forces the unloaded outlines overlap by 80.0 %", quality);
  quality.material->breast_dice = 0.7;
  expect(Grade::failed, "overlap by 70.0 % only", quality);
}

TEST(Verdict, SeesAStageThatMadeTheOutlinesWorse) {
  Quality quality = right();
  quality.image_forces->breast_dice = 0.972;
  expect(Grade::doubtful, "image forces made the outlines agree less", quality);
}

TEST(Verdict, TakesCorrelationForMetricsOfTheSameContrastOnly) {
  Quality quality = right();
  quality.image_forces->intensities->correlation = -0.5;
  expect(Grade::failed, "correlate by -0.50", quality);
  quality.same_contrast = false;
  EXPECT_STREQ(name_of(judge(quality).grade), "good");
}

TEST(Verdict, JudgesWhatThereIsWithoutTheLastStages) {
  Quality quality = right();
  quality.material.reset();
  quality.image_forces.reset();
  quality.unloaded->breast_dice = 0.5;
  expect(Grade::failed, "overlap by 50.0 % only", quality);
}

} // namespace
} // namespace prosup::tests
