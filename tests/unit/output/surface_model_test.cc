#include "prosup/output/surface_model.h"

#include <gtest/gtest.h>

#include <vector>

#include "expect_error.h"
#include "temporary_folder.h"
#include "text_file.h"

namespace prosup::tests {
namespace {

using namespace prosup::output;
using dealii::Point;

const char* const tetrahedron = "v 0 0 0\nv 10 0 0\nv 0 20 0\nv 0 0 30\n"
                                "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

/// The points of a model, in the order of its cells.
std::vector<Point<3>> points_of(const std::filesystem::path& file) {
  const TemporaryFolder folder;
  std::vector<Point<3>> points;
  move_model(file, folder / "same.vtp", [&](const Point<3>& p) {
    points.push_back(p);
    return p;
  });
  return points;
}

bool holds(const std::vector<Point<3>>& points, const Point<3>& p) {
  for (const Point<3>& point : points)
    if (point.distance(p) < 1e-4)
      return true;
  return false;
}

TEST(SurfaceModel, IsMovedAndWrittenInEachFormat) {
  const TemporaryFolder folder;
  std::filesystem::path from = text_file(folder / "in.obj", tetrahedron);
  double moved = 0.;
  for (const char* name : {"1.vtp", "2.stl", "3.obj", "4.VTP"}) {
    const std::size_t n = move_model(from, folder / name, [](const Point<3>& p) {
      return p + dealii::Tensor<1, 3>({1., 2., 3.});
    });
    moved += 1.;
    EXPECT_EQ(n, 4u) << name;
    const auto points = points_of(folder / name);
    ASSERT_EQ(points.size(), 4u) << name;
    EXPECT_TRUE(holds(points, Point<3>(10. + moved, 2. * moved, 3. * moved))) << name;
    EXPECT_TRUE(holds(points, Point<3>(moved, 2. * moved, 30. + 3. * moved))) << name;
    from = folder / name;
  }
}

TEST(SurfaceModel, ThatSaysRasIsTurned) {
  const TemporaryFolder folder;
  const auto from =
      text_file(folder / "in.obj", std::string("# 3D Slicer output. SPACE=RAS\n") + tetrahedron);
  move_model(from, folder / "out.stl", [](const Point<3>& p) { return p; });
  const auto points = points_of(folder / "out.stl");
  EXPECT_TRUE(holds(points, Point<3>(-10., 0., 0.)));
  EXPECT_TRUE(holds(points, Point<3>(0., -20., 0.)));
  EXPECT_NE(contents(folder / "out.stl").find("SPACE=LPS"), std::string::npos);
}

// Lines without faces, which of the formats that are written VTP only holds.
TEST(SurfaceModel, OfAContourIsMoved) {
  const TemporaryFolder folder;
  const auto contour = text_file(folder / "in.obj", "v 0 0 0\nv 10 0 0\nv 0 20 0\nl 1 2 3 1\n");
  const auto shifted = [](const Point<3>& p) { return p + dealii::Tensor<1, 3>({1., 2., 3.}); };
  EXPECT_EQ(move_model(contour, folder / "out.vtp", shifted), 3u);
  EXPECT_EQ(points_of(folder / "out.vtp").size(), 3u);
  EXPECT_TRUE(holds(points_of(folder / "out.vtp"), Point<3>(11., 2., 3.)));
  const std::string written = contents(folder / "out.vtp");
  EXPECT_NE(written.find("NumberOfLines=\"1\""), std::string::npos) << written.substr(0, 500);
  for (const char* name : {"out.stl", "out.obj"})
    expect_error([&] { move_model(contour, folder / name, shifted); },
                 {"no faces", std::string("as ") + (name + 3), ".vtp"});
}

TEST(SurfaceModel, ThatCannotBeUsedIsRefused) {
  const TemporaryFolder folder;
  const auto same = [](const Point<3>& p) { return p; };
  expect_error([&] { move_model(folder / "no.stl", folder / "o.stl", same); },
               {"no.stl", "does not exist", ".vtp"});
  for (const char* name : {"bad.vtp", "bad.stl", "bad.obj"}) {
    const auto bad = text_file(folder / name, "this is no model\n");
    expect_error([&] { move_model(bad, folder / "o.vtp", same); }, {name, "cannot be read"});
  }
  const auto good = text_file(folder / "in.obj", tetrahedron);
  expect_error([&] { move_model(good, folder / "no/folder.stl", same); }, {"cannot be written"});
  expect_error(
      [&] {
        move_model(good, folder / "o.vtp", [](const Point<3>&) {
          return Point<3>(std::numeric_limits<double>::quiet_NaN(), 0., 0.);
        });
      },
      {"in.obj", "cannot be mapped"});
  EXPECT_FALSE(std::filesystem::exists(folder / "o.vtp"));
}

TEST(SurfaceModel, IsKnownByItsEnding) {
  EXPECT_TRUE(is_model("a.STL"));
  EXPECT_TRUE(is_model("b/c.vtp"));
  EXPECT_FALSE(is_model("a.nii.gz"));
  EXPECT_FALSE(is_model("stl"));
}

} // namespace
} // namespace prosup::tests
