#include "prosup/evaluation/observers.h"

#include <gtest/gtest.h>

#include <cmath>

#include "affine_mesh.h"
#include "expect_error.h"
#include "temporary_folder.h"
#include "text_file.h"

namespace prosup::tests {
namespace {

using namespace prosup::evaluation;

Landmark landmark(const std::string& id, const Point<3>& prone, const Point<3>& supine) {
  return {id, prone, supine, {}};
}

/// Three structures; the second observer took another one for `b`.
const LandmarkObserver first{"first",
                             {landmark("a", Point<3>(0, 0, 0), Point<3>(3, 0, 0)),
                              landmark("b", Point<3>(0, 0, 0), Point<3>(0, 5, 0)),
                              landmark("c", Point<3>(1, 1, 1), Point<3>(1, 1, 2))}};
const LandmarkObserver second{"second",
                              {landmark("c", Point<3>(1, 1, 1), Point<3>(1, 1, 8)),
                               landmark("a", Point<3>(0, 0, 0), Point<3>(3, 4, 0)),
                               landmark("b", Point<3>(0, 0, 0), Point<3>(0, 17, 0)),
                               landmark("d", Point<3>(0, 0, 0), Point<3>(0, 0, 0))}};

TEST(Observers, DistancesBeforeAndAfterExclusion) {
  const ObserverStudy study({first, second}, 10.);
  EXPECT_EQ(study.n_landmarks(), 3u);
  EXPECT_EQ(study.n_incomplete(), 1u); // d
  EXPECT_EQ(study.outliers(), std::vector<std::string>{"b"});
  const auto distances = study.distances();
  ASSERT_EQ(distances.size(), 1u); // the prone positions are the same
  EXPECT_EQ(distances[0].state, "supine");
  EXPECT_NEAR(distances[0].all.mean, 22. / 3., 1e-12); // of 4, 12 and 6
  EXPECT_NEAR(distances[0].all.std, std::sqrt(52. / 3.), 1e-12);
  EXPECT_NEAR(distances[0].all.max, 12., 1e-12);
  EXPECT_EQ(distances[0].reliable.n, 2u);
  EXPECT_NEAR(distances[0].reliable.mean, 5., 1e-12);
  EXPECT_NEAR(distances[0].reliable.std, std::sqrt(2.), 1e-12);
}

TEST(Observers, ErrorsOfEachAndOfAllTogether) {
  const mesh::TetMesh box = box_of_tets(Point<3>(-20., -20., -20.), Point<3>(20., 20., 20.), 2);
  const AffineMap identity{dealii::Tensor<2, 3>({{1., 0., 0.}, {0., 1., 0.}, {0., 0., 1.}}), {}};
  AffineMap shift = identity; // unloaded supine = supine - (1, 0, 0)
  shift.b[0] = 1.;
  const PointMapper prone(affine_mesh(box, identity)), supine(affine_mesh(box, shift));
  const auto rows = ObserverStudy({first, second}, 10.).rows(prone, supine);
  ASSERT_EQ(rows.size(), 6u);
  EXPECT_NEAR(rows[0].initial.mean, 3., 1e-9); // of 3, 5 and 1
  EXPECT_NEAR(rows[0].error.mean, (2. + std::sqrt(26.) + std::sqrt(2.)) / 3., 1e-9);
  EXPECT_EQ(rows[2].selection, Selection::reliable);
  EXPECT_NEAR(rows[2].error.mean, (2. + std::sqrt(2.)) / 2., 1e-9);
  EXPECT_EQ(rows[4].observer, "combined");
  EXPECT_EQ(rows[4].error.n, 4u);
  EXPECT_NEAR(rows[4].error.mean, (2. + std::sqrt(2.) + std::sqrt(20.) + std::sqrt(50.)) / 4.,
              1e-9);
  EXPECT_EQ(rows[5].observer, "mean position");
  EXPECT_NEAR(rows[5].error.mean, (std::sqrt(8.) + std::sqrt(17.)) / 2., 1e-9);
}

TEST(Observers, ControlObserverHasTheProneLandmarksOfTheFirst) {
  const TemporaryFolder folder;
  for (const char* header : {"id,x,y,z", "id,supine_x,supine_y,supine_z"}) {
    const auto file =
        text_file(folder / "control.csv", std::string(header) + "\nc,1,1,5\na,3,0,2\n");
    Remarks remarks;
    const LandmarkObserver control = read_control_observer(file, first, remarks);
    EXPECT_EQ(control.name, "control");
    ASSERT_EQ(control.landmarks.size(), 2u);
    EXPECT_EQ(control.landmarks[0].prone, Point<3>(1, 1, 1));
    EXPECT_EQ(control.landmarks[0].supine, Point<3>(1, 1, 5));
  }
}

TEST(Observers, WhereAllAreExcludedThereIsNoFigure) {
  const ObserverStudy study({first, second}, 1.);
  EXPECT_EQ(study.outliers().size(), 3u);
  const TemporaryFolder folder;
  write_observer_tables({}, study.distances(), folder / "out.csv");
  EXPECT_EQ(contents(folder / "out.csv"),
            "quantity,observer,landmarks,n,mean_mm,std_mm,max_mm\n"
            "observer_distance_supine,first - second,all,3,7.3333,4.1633,12.0000\n"
            "observer_distance_supine,first - second,reliable,0,,,\n");
  EXPECT_NE(observer_tables({}, study.distances()).find("| 7.3 | 12.0 | 4.2 | - | - | - | 3 | 3 |"),
            std::string::npos);
}

TEST(Observers, MistakesAreNamed) {
  const TemporaryFolder folder;
  const auto file = text_file(folder / "control.csv", "id,x,y,z\ne,1,1,5\n");
  Remarks remarks;
  expect_error([&] { read_control_observer(file, first, remarks); },
               {"'e'", "control.csv", "'first'"});
  expect_error([] { ObserverStudy({}, 10.); }, {"No observer"});
  const LandmarkObserver other{"other", {landmark("z", Point<3>(), Point<3>())}};
  expect_error([&] { ObserverStudy({first, other}, 10.); }, {"same id"});
}

} // namespace
} // namespace prosup::tests
