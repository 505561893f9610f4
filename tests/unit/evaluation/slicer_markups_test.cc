#include <gtest/gtest.h>

#include "expect_error.h"
#include "prosup/evaluation/points.h"
#include "temporary_folder.h"

namespace prosup::tests {
namespace {

using namespace prosup::evaluation;

/// A list with the entry `units`, and other `entries` in each of two points.
std::string markups(const std::string& entries, const std::string& of_second = "") {
  return R"({"markups": [{)" + entries + R"("controlPoints": [
    {"label": "F", "position": [1, 2, 3]}, {"label": "G", "position": [4, 5, 6])" +
         of_second + "}]}]}";
}

std::vector<NamedPoint> parse(const std::string& text, Remarks& remarks,
                              PointFormat format = PointFormat::mrk_json) {
  return parse_points(text, format, "some.mrk.json", remarks);
}

const std::string lps = R"("coordinateSystem": "LPS", )";

TEST(MrkJson, SaysWhatWasAssumed) {
  struct Case {
    std::string text, remark;
    std::size_t n_points = 2;
  };
  for (const Case& c :
       {Case{markups(""), "does not name its coordinate system; its points were taken as LPS"},
        {markups(lps + R"("type": "Line", )"), "'Line'"},
        {markups(lps, R"(, "positionStatus": "preview")"), "1 points are named but not placed", 1},
        {markups(lps, R"(, "positionStatus": "undefined")"), "1 points are named", 1},
        {markups(lps + R"("type": "Fiducial", "coordinateUnits": ["mm", "mm", "mm"], )"), ""}}) {
    Remarks remarks;
    EXPECT_EQ(parse(c.text, remarks).size(), c.n_points);
    ASSERT_EQ(remarks.all().size(), c.remark.empty() ? 0u : 1u) << c.text;
    if (!c.remark.empty()) {
      EXPECT_NE(remarks.all()[0].find(c.remark), std::string::npos) << remarks.all()[0];
    }
  }
}

TEST(MrkJson, TakesSeveralListsWithTheirOwnSystems) {
  Remarks remarks;
  const std::string first = markups(lps), second = markups(R"("coordinateSystem": "RAS", )");
  const auto list = [](const std::string& text) { // what is between the outer brackets
    return text.substr(13, text.size() - 15);
  };
  const auto points = parse("\xEF\xBB\xBF{\"markups\": [" + list(first) + ", " + list(second) +
                                ", {\"type\": \"Plane\", \"coordinateSystem\": \"LPS\"}]}",
                            remarks);
  ASSERT_EQ(points.size(), 4u);
  EXPECT_EQ(points[1].position, Point<3>(4., 5., 6.));
  EXPECT_EQ(points[3].position, Point<3>(-4., -5., 6.));
}

TEST(MrkJson, WhatCannotBeRightIsRefused) {
  struct Case {
    std::string text;
    std::vector<std::string> message;
  };
  for (const Case& c : {
           Case{markups(R"("coordinateSystem": 7, )"), {"'7'", "LPS or RAS"}},
           Case{markups(R"("coordinateSystem": "", )"), {"LPS or RAS"}},
           Case{markups(lps + R"("coordinateUnits": "um", )"), {"'um'", "mm"}},
           Case{markups(lps + R"("coordinateUnits": ["mm", "mm", "um"], )"), {"um", "in mm"}},
           Case{markups(lps + R"("coordinateUnits": {"code": "cm"}, )"), {"cm"}},
           Case{markups(lps, R"(, "position": [1, 2, null])"), {"'G'", "three coordinates"}},
           Case{markups(lps, R"(, "position": [1, 2, "3"])"), {"'G'", "three coordinates"}},
           Case{markups(lps, R"(, "position": null)"), {"'G'", "three coordinates"}},
           Case{markups(lps, R"(, "position": [1, 2, 3, 4])"), {"'G'", "three coordinates"}},
           Case{markups(lps, R"(, "position": [1e300, 2, 3])"), {"'G'", "no position"}},
           Case{markups(lps, R"(, "position": [1e999, 2, 3])"), {"not a markups file"}},
           Case{markups(lps, R"(, "position": [NaN, 2, 3])"), {"line 2", "no JSON"}},
           Case{"", {"line 1", "no JSON"}},
           Case{"[]", {"'markups'"}},
           Case{"7", {"'markups'"}},
           Case{R"({"markups": {}})", {"'markups'"}},
           Case{R"({"markups": [3]})", {"no object"}},
           Case{R"({"markups": []})", {"no points"}},
           Case{R"({"markups": [{"controlPoints": 3}]})", {"no list"}},
           Case{R"({"markups": [{"controlPoints": [3]}]})", {"no object"}},
           Case{R"({"markups": [{"controlPoints": [{"positionStatus": "undefined"}]}]})",
                {"none of its 1 control points was placed"}},
       }) {
    Remarks remarks;
    auto parts = c.message;
    parts.emplace_back("some.mrk.json");
    expect_error([&] { parse(c.text, remarks); }, parts);
  }
}

TEST(Fcsv, TakesItsColumnsFromTheHeader) {
  Remarks remarks;
  const auto points = parse("# Markups fiducial file version = 5.6\r\n"
                            "# columns = label,z,y,x,id\r\n# CoordinateSystem = lps\r\n"
                            "F,3,2,1,7\r\n,6,5,4,8\r\n",
                            remarks, PointFormat::fcsv);
  ASSERT_EQ(points.size(), 2u);
  EXPECT_EQ(points[0].id, "F");
  EXPECT_EQ(points[0].position, Point<3>(1., 2., 3.));
  EXPECT_EQ(points[1].id, "8");
}

TEST(Fcsv, WhatCannotBeRightIsRefused) {
  const std::string head = "# CoordinateSystem = RAS\n";
  for (const auto& [text, part] : std::vector<std::pair<std::string, std::string>>{
           {head + "a,1,2,3\n# CoordinateSystem = LPS\nb,1,2,3\n", "changes within"},
           {"# CoordinateSystem = IJK\na,1,2,3\n", "'IJK'"},
           {"# CoordinateSystem =\na,1,2,3\n", "LPS or RAS"},
           {head + "# columns =\na,1,2,3\n", "''"},
           {head + "a,1,nan,3\n", "column 'y'"},
           {head + "a;1;2;3\n", "at least four"}}) {
    Remarks remarks;
    const std::string list = text;
    expect_error([&] { parse(list, remarks, PointFormat::fcsv); }, {part, "some.mrk.json"});
  }
}

TEST(WrittenMarkups, AreReadBack) {
  const TemporaryFolder folder;
  const std::vector<NamedPoint> points{{"a", {1.25, -2.5, 300.}},
                                       {"\"b\", two\nlines, \xC3\xA4", {0., 0., 1e-6}}};
  for (const char* name : {"p.csv", "p.FCSV", "p.mrk.json"}) {
    write_points(points, folder / name, output_format(folder / name));
    Remarks remarks;
    const auto read = read_points(folder / name, remarks);
    ASSERT_EQ(read.size(), 2u) << name;
    EXPECT_TRUE(remarks.all().empty());
    for (unsigned p = 0; p < 2; ++p) {
      EXPECT_EQ(read[p].id, points[p].id) << name;
      EXPECT_LT(read[p].position.distance(points[p].position), 1e-9) << name;
    }
  }
  EXPECT_EQ(output_format("/dev/stdout"), PointFormat::csv);
  EXPECT_EQ(output_format("p.txt"), PointFormat::csv);
  for (const char* name : {"p.json", "p.xlsx"})
    expect_error([&] { output_format(name); }, {name, ".csv", ".mrk.json"});
}

} // namespace
} // namespace prosup::tests
