#include "prosup/evaluation/target_registration_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "affine_mesh.h"
#include "expect_error.h"
#include "prosup/evaluation/landmarks_csv.h"
#include "temporary_folder.h"
#include "text_file.h"

namespace prosup::tests {
namespace {

using namespace prosup::evaluation;

const Point<3> low(-20., -20., -20.), high(20., 20., 20.);

std::vector<Landmark> landmarks_of(const AffineMap& prone, const AffineMap& supine,
                                   const std::vector<double>& errors) {
  std::vector<Landmark> landmarks;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const Point<3> X(2. * double(i) - 5., 3., -1.), Y = X + Point<3>(0., errors[i], 0.);
    landmarks.push_back({"L" + std::to_string(i), prone(X), supine(Y), X});
  }
  return landmarks;
}

TEST(TargetRegistrationError, StatisticsOfKnownDistances) {
  std::vector<double> distances;
  for (int i = 20; i >= 0; --i)
    distances.push_back(i);
  const ErrorStatistics s = statistics(distances);
  EXPECT_EQ(s.n, 21u);
  EXPECT_DOUBLE_EQ(s.mean, 10.);
  EXPECT_DOUBLE_EQ(s.std, std::sqrt(770. / 20.));
  EXPECT_DOUBLE_EQ(s.p95, 19.);
  EXPECT_DOUBLE_EQ(s.max, 20.);
  EXPECT_DOUBLE_EQ(statistics({1., 2.}).p95, 1.95);
  EXPECT_EQ(statistics({3.}).std, 0.);
}

TEST(TargetRegistrationError, RefusesNothingAndNotANumber) {
  expect_error([] { statistics({}); }, {"at least one landmark"});
  expect_error(
      [] {
        statistics({1., std::numeric_limits<double>::quiet_NaN()});
      },
      {"not a finite number"});
}

// Both breasts are deformed alike from the unloaded state in which the pairs
// are apart by known distances, so unloading must find just these.
TEST(TargetRegistrationError, IsTheDistanceInTheUnloadedConfiguration) {
  const auto prone_map = stretch_and_shear(), supine_map = other_stretch_and_shear();
  const auto box = box_of_tets(low, high, 4);
  const PointMapper prone(affine_mesh(box, prone_map));
  const PointMapper supine(affine_mesh(box, supine_map));
  const auto landmarks = landmarks_of(prone_map, supine_map, {0., 1., 2., 3., 4.});
  const ErrorStatistics error = unloaded_error(landmarks, prone, supine);
  EXPECT_NEAR(error.mean, 2., 1e-9);
  EXPECT_NEAR(error.max, 4., 1e-9);
  EXPECT_EQ(error.n, 5u);
  double mean = 0.;
  for (const auto& landmark : landmarks)
    mean += landmark.prone.distance(landmark.supine) / 5.;
  EXPECT_NEAR(initial_error(landmarks).mean, mean, 1e-12);
}

TEST(TargetRegistrationError, TableHasTheStepsOfThePaper) {
  const std::string table = error_table({{step_name::initial, {19.3, 16.2, 58.7, 50.1, 500}},
                                         {step_name::image_forces, {0.9, 0.8, 6.1, 2.25, 500}}});
  EXPECT_EQ(table, "Target registration error (mm)     mean      std      p95      max\n"
                   "No registration                   19.30    16.20    50.10    58.70\n"
                   "Image forces                       0.90     0.80     2.25     6.10\n");
}

TEST(LandmarksCsv, HoldsBothUnloadedPositionsAndTheirDistance) {
  const auto identity =
      AffineMap{dealii::Tensor<2, 3>({{1., 0., 0.}, {0., 1., 0.}, {0., 0., 1.}}), {}};
  const AffineMap shift{identity.A, dealii::Tensor<1, 3>({1., 0., 0.})};
  const auto box = box_of_tets(low, high, 2);
  const PointMapper prone(affine_mesh(box, identity)), supine(affine_mesh(box, shift));
  const TemporaryFolder folder;
  const auto file = folder / "landmarks.csv";
  const std::vector<Landmark> landmarks = {{"a,b", {1., 2., 3.}, {4., 2., 7.}, {}}};
  write_landmarks(map_landmarks(landmarks, prone, supine), file);
  EXPECT_EQ(contents(file),
            "id,prone_x,prone_y,prone_z,supine_x,supine_y,supine_z,"
            "unloaded_from_prone_x,unloaded_from_prone_y,unloaded_from_prone_z,"
            "unloaded_from_supine_x,unloaded_from_supine_y,unloaded_from_supine_z,tre_mm\n"
            "\"a,b\",1.000000,2.000000,3.000000,4.000000,2.000000,7.000000,"
            "1.000000,2.000000,3.000000,3.000000,2.000000,7.000000,4.472136\n");
  EXPECT_EQ(read_landmarks(file).at(0).id, "a,b");
}

TEST(LandmarksCsv, RefusesNotANumber) {
  const TemporaryFolder folder;
  MappedLandmark bad;
  bad.landmark.id = "L7";
  bad.from_prone.position[1] = std::numeric_limits<double>::infinity();
  const auto file = folder / "landmarks.csv";
  expect_error([&] { write_landmarks({bad}, file); }, {"landmark 'L7'", "not a finite"});
  EXPECT_FALSE(std::filesystem::exists(file));
}

} // namespace
} // namespace prosup::tests
