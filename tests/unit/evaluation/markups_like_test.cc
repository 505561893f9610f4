#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "expect_error.h"
#include "prosup/evaluation/points.h"
#include "temporary_folder.h"
#include "text_file.h"

namespace prosup::tests {
namespace {

using namespace prosup::evaluation;
using Json = nlohmann::json;

const char* const original = R"({"@schema": "s", "markups": [
  {"type": "Curve", "coordinateSystem": "RAS", "locked": true, "measurements": [{"value": 1}],
   "display": {"color": [1.0, 0.5, 0.0], "glyphScale": 3.0},
   "controlPoints": [
     {"id": "1", "label": "lesion", "position": [1, 2, 3], "visibility": false},
     {"id": "2", "label": "later", "position": [0, 0, 0], "positionStatus": "undefined"},
     {"id": "7", "label": "clip", "position": [4, 5, 6], "description": "old"}]},
  {"type": "Plane", "center": [9, 9, 9], "display": {"color": [0.0, 0.0, 1.0]},
   "controlPoints": [{"id": "1", "label": "p", "position": [7, 8, 9]}]}]})";

class MarkupsLike : public ::testing::Test {
protected:
  /// The file with all its points moved by (10, 20, 30) mm, LPS.
  Json moved(const std::string& text = original) const {
    const auto file = text_file(folder_ / "in.mrk.json", text);
    std::vector<NamedPoint> points = read_points(file);
    for (NamedPoint& point : points) {
      point.position += dealii::Tensor<1, 3>({10., 20., 30.});
      point.figures = MapFigures{0.9, 0., {12., 30.}, {11.5, {}}, 50., 45.25};
    }
    write_markups_like(file, points, folder_ / "out.mrk.json");
    return Json::parse(contents(folder_ / "out.mrk.json"));
  }
  const TemporaryFolder folder_;
};

TEST_F(MarkupsLike, KeepNamesColoursAndCoordinateSystem) {
  const Json curve = moved()["markups"][0];
  EXPECT_EQ(curve["type"], "Curve");
  EXPECT_EQ(curve["coordinateSystem"], "RAS");
  EXPECT_EQ(curve["display"]["color"], Json::array({1.0, 0.5, 0.0}));
  EXPECT_EQ(curve["display"]["glyphScale"], 3.0);
  EXPECT_EQ(curve["locked"], true);
  EXPECT_EQ(curve["controlPoints"][0]["label"], "lesion");
  EXPECT_EQ(curve["controlPoints"][0]["visibility"], false);
  EXPECT_EQ(curve["controlPoints"][0]["position"], Json::array({-9., -18., 33.}));
  EXPECT_EQ(curve["controlPoints"][1]["id"], "7");
  EXPECT_EQ(curve["controlPoints"][1]["position"], Json::array({-6., -15., 36.}));
}

TEST_F(MarkupsLike, LeaveOutWhatBelongsToTheOldPositions) {
  const Json markups = moved()["markups"];
  EXPECT_EQ(markups[0]["controlPoints"].size(), 2u);
  EXPECT_FALSE(markups[0].contains("measurements"));
  EXPECT_EQ(markups[1]["type"], "Fiducial");
  EXPECT_FALSE(markups[1].contains("center"));
  EXPECT_EQ(markups[1]["coordinateSystem"], "LPS");
  EXPECT_EQ(markups[1]["display"]["color"], Json::array({0.0, 0.0, 1.0}));
}

TEST_F(MarkupsLike, AreReadBackWhereTheyWereWritten) {
  moved();
  const auto points = read_points(folder_ / "out.mrk.json");
  ASSERT_EQ(points.size(), 3u);
  EXPECT_EQ(points[0].position, Point<3>(9., 18., 33.));
  EXPECT_EQ(points[2].position, Point<3>(17., 28., 39.));
  EXPECT_EQ(points[2].id, "p");
}

// A distance that is not known on one side is not told. What somebody has written stays, what
// prosup has written before is replaced.
TEST_F(MarkupsLike, DescribeWhatIsKnown) {
  const Json once = moved();
  const std::string figures =
      "prosup: J 0.900; skin 11.5 mm away (before: 12.0 mm); nipple 45.2 mm away (before: 50.0 mm)";
  for (const Json& file : {once, moved(once.dump())}) {
    const Json& points = file["markups"][0]["controlPoints"];
    EXPECT_EQ(points[0]["description"], figures);
    EXPECT_EQ(points[1]["description"], "old; " + figures);
  }
}

TEST_F(MarkupsLike, OfAFileThatChangedAreRefused) {
  const auto file = text_file(folder_ / "in.mrk.json", original);
  expect_error(
      [&] {
        write_markups_like(file, {{"a", {}}}, folder_ / "out.mrk.json");
      },
      {"in.mrk.json", "changed"});
}

} // namespace
} // namespace prosup::tests
