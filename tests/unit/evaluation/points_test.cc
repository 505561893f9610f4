#include "prosup/evaluation/points.h"

#include <gtest/gtest.h>

#include <limits>

#include "expect_error.h"
#include "temporary_folder.h"
#include "text_file.h"

namespace prosup::tests {
namespace {

using namespace prosup::evaluation;

std::string fcsv(const std::string& system) {
  return "# Markups fiducial file version = 4.11\n# CoordinateSystem = " + system +
         "\n# columns = id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label,desc,associatedNodeID\n"
         "vtkMRMLMarkupsFiducialNode_0,1.5,-2,3,0,0,0,1,1,1,0,\"F,1\",,\n2,4,5,6\n";
}

std::string mrk_json(const std::string& markup_entries) {
  return R"({"@schema": "markups-schema-v1.0.3.json#", "markups": [{"type": "Fiducial", )" +
         markup_entries + R"("controlPoints": [
    {"id": "1", "label": "F-1", "position": [1.5, -2, 3], "positionStatus": "defined"},
    {"id": "2", "label": "skipped", "position": [0, 0, 0], "positionStatus": "undefined"},
    {"id": "3", "label": "", "position": [4, 5, 6]}]}]})";
}

void expect_two_points(const std::vector<NamedPoint>& points, const std::string& first,
                       const std::string& second, double sign) {
  ASSERT_EQ(points.size(), 2u);
  EXPECT_EQ(points[0].id, first);
  EXPECT_EQ(points[0].position, Point<3>(sign * 1.5, sign * -2., 3.));
  EXPECT_EQ(points[1].id, second);
  EXPECT_EQ(points[1].position, Point<3>(sign * 4., sign * 5., 6.));
}

TEST(Points, CsvInAnyColumnOrder) {
  const TemporaryFolder folder;
  expect_two_points(read_points(text_file(folder / "p.csv", "z,id,y,x\n3,a,-2,1.5\n6,b,5,4\n")),
                    "a", "b", 1.);
}

TEST(Points, FcsvInItsCoordinateSystem) {
  const TemporaryFolder folder;
  for (const std::string lps : {"LPS", "1"})
    expect_two_points(read_points(text_file(folder / "p.fcsv", fcsv(lps))), "F,1", "2", 1.);
  for (const std::string ras : {"RAS", "0"})
    expect_two_points(read_points(text_file(folder / "p.fcsv", fcsv(ras))), "F,1", "2", -1.);
}

TEST(Points, MrkJsonInItsCoordinateSystem) {
  const TemporaryFolder folder;
  const auto read = [&](const std::string& entries) {
    return read_points(text_file(folder / "p.mrk.json", mrk_json(entries)));
  };
  expect_two_points(read(R"("coordinateSystem": "LPS", "coordinateUnits": "mm", )"), "F-1", "3",
                    1.);
  expect_two_points(read(R"("coordinateSystem": "RAS", )"), "F-1", "3", -1.);
  expect_two_points(read(""), "F-1", "3", 1.);
}

TEST(Points, AreWrittenAndReadBack) {
  const TemporaryFolder folder;
  const auto file = folder / "out.csv";
  write_points({{"a", {1.25, -2.000001, 3e2}}, {"say \"b, c\"", {0., 0., 1e-6}}}, file);
  const auto points = read_points(file);
  ASSERT_EQ(points.size(), 2u);
  EXPECT_EQ(points[0].position, Point<3>(1.25, -2.000001, 300.));
  EXPECT_EQ(points[1].id, "say \"b, c\"");
  EXPECT_EQ(points[1].position, Point<3>(0., 0., 1e-6));
}

TEST(Points, WithErrorBarsHaveMoreColumns) {
  const TemporaryFolder folder;
  const ErrorBar bar{dealii::Tensor<1, 3>({0.5, 0.25, 2.}), 4.125};
  write_points({{"a", {1., 2., 3.}, bar}}, folder / "out.csv");
  EXPECT_EQ(contents(folder / "out.csv"),
            std::string(points_header) + error_columns +
                "\na,1.000000,2.000000,3.000000,0.500000,0.250000,2.000000,4.125000\n");
  for (const char* name : {"out.fcsv", "out.mrk.json"}) {
    write_points({{"a", {1., 2., 3.}, bar}}, folder / name, point_format(name));
    EXPECT_NE(contents(folder / name).find("95 % within 4.12 mm"), std::string::npos) << name;
    EXPECT_EQ(read_points(folder / name).at(0).position, Point<3>(1., 2., 3.)) << name;
  }
  write_points({{"a", {1., 2., 3.}, bar}, {"b", {4., 5., 6.}}}, folder / "some.csv");
  EXPECT_NE(contents(folder / "some.csv").find("\nb,4.000000,5.000000,6.000000,,,,\n"),
            std::string::npos);
  const ErrorBar wrong{{}, std::numeric_limits<double>::infinity()};
  expect_error(
      [&] {
        write_points({{"a", {1., 2., 3.}, wrong}}, folder / "wrong.csv");
      },
      {"point 'a'", "not a finite number"});
}

// An unknown distance is an empty value; the columns that came first stay first.
TEST(Points, WithFiguresOfAMapHaveMoreColumns) {
  const TemporaryFolder folder;
  const MapFigures figures{0.875, 1.5, {12., 30.}, {11., {}}, 50., {}};
  write_points({{"a", {1., 2., 3.}, {}, figures}}, folder / "out.csv");
  EXPECT_EQ(contents(folder / "out.csv"),
            std::string(points_header) + figure_columns +
                "\na,1.000000,2.000000,3.000000,0.875000,1.500000,12.000000,30.000000,11.000000,"
                ",50.000000,\n");
  EXPECT_EQ(read_points(folder / "out.csv").at(0).position, Point<3>(1., 2., 3.));
  const MapFigures wrong{std::numeric_limits<double>::infinity(), 0., {}, {}};
  expect_error(
      [&] {
        write_points({{"a", {}, {}, wrong}}, folder / "wrong.csv");
      },
      {"point 'a'", "not a finite number"});
}

TEST(Points, ThatAreNotFiniteAreNotWritten) {
  const TemporaryFolder folder;
  const auto file = folder / "out.csv";
  expect_error(
      [&] {
        write_points({{"q", {0., std::numeric_limits<double>::quiet_NaN(), 0.}}}, file);
      },
      {"point 'q'", "not a finite number"});
  EXPECT_FALSE(std::filesystem::exists(file));
  expect_error([&] { write_points({}, folder / "no/out.csv"); }, {"cannot be written"});
}

struct BadFile {
  std::string name, text;
  std::vector<std::string> message;
};

class BadPoints : public ::testing::TestWithParam<BadFile> {};

TEST_P(BadPoints, AreRefusedWithTheirFile) {
  const TemporaryFolder folder;
  const auto file = text_file(folder / GetParam().name, GetParam().text);
  auto parts = GetParam().message;
  parts.push_back(GetParam().name);
  expect_error([&] { read_points(file); }, parts);
}

INSTANTIATE_TEST_SUITE_P(
    All, BadPoints,
    ::testing::Values(
        BadFile{"p.txt", "id,x,y,z\n", {".fcsv or .mrk.json"}},
        BadFile{"p.csv", "id,x,y\na,1,2\n", {"no column 'z'"}},
        BadFile{"p.csv", "id,x,y,z\na,1,2,three\n", {"line 2", "'three'"}},
        BadFile{"p.fcsv", fcsv("IJK"), {"line 2", "'IJK'", "LPS or RAS"}},
        BadFile{"p.fcsv", "1,2,3,4\n", {"coordinate system"}},
        BadFile{"p.fcsv", "# CoordinateSystem = LPS\n1,2,3\n", {"line 2", "3 values"}},
        BadFile{"p.fcsv", "# CoordinateSystem = LPS\n1,2,3,x\n", {"line 2", "'x'"}},
        BadFile{"p.fcsv", "# CoordinateSystem = LPS\n", {"no points"}},
        BadFile{"p.mrk.json", "{", {"not a markups file"}},
        BadFile{"p.mrk.json", "{\"a\": 1}", {"not a markups file"}},
        BadFile{"p.mrk.json", mrk_json(R"("coordinateSystem": "IJK", )"), {"'IJK'"}},
        BadFile{"p.mrk.json", mrk_json(R"("coordinateUnits": "cm", )"), {"'cm'", "mm"}},
        BadFile{"p.mrk.json",
                R"({"markups": [{"controlPoints": [{"label": "F", "position": [1, 2]}]}]})",
                {"'F'", "three coordinates"}},
        BadFile{"p.mrk.json",
                R"({"markups": [{"controlPoints": [{"label": "F", "position": [1, 2, null]}]}]})",
                {"'F'", "three coordinates"}}));

} // namespace
} // namespace prosup::tests
